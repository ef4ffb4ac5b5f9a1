#include "lsystems/tubes.h"

#include <gtest/gtest.h>
TEST(Tubes,Nothing){}
