# Writes city.tiles as a C++ constant: cmake -DTILES=<file> -DOUT=<file> -P shipped_tile_set.cmake
file(READ ${TILES} text)
# a literal may have 65,536 characters at most, so that the text is cut into several
string(LENGTH "${text}" length)
set(pieces "")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 piece)
  string(APPEND pieces "R\"tiles(${piece})tiles\"\n")
  math(EXPR at "${at} + 8000")
endwhile()
file(WRITE ${OUT} "#pragma once\ninline constexpr const char* kShippedTileSet =\n${pieces};\n")
