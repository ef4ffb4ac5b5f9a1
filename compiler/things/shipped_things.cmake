# Writes the files of grammars/things as a C++ table: cmake -DTHINGS=<folder> -DOUT=<file> -P shipped_things.cmake
file(GLOB_RECURSE files RELATIVE ${THINGS} ${THINGS}/*.cga ${THINGS}/things.txt)
list(SORT files COMPARE STRING)
set(rows "")
foreach(name ${files})
  file(READ ${THINGS}/${name} text)
  string(APPEND rows "{\"${name}\", R\"rule(${text})rule\"},\n")
endforeach()
file(WRITE ${OUT} "${rows}")
