# Writes the files of grammars/rules as a C++ table: cmake -DRULES=<folder> -DOUT=<file> -P shipped_rules.cmake
file(GLOB_RECURSE files RELATIVE ${RULES} ${RULES}/*.cga)
list(SORT files COMPARE STRING)
set(rows "")
foreach(name ${files})
  file(READ ${RULES}/${name} text)
  string(APPEND rows "{\"${name}\", R\"rule(${text})rule\"},\n")
endforeach()
file(WRITE ${OUT} "${rows}")
