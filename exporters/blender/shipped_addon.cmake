# Writes the files of the add-on as a C++ table: cmake -DADDON=<folder> -DOUT=<file> -P shipped_addon.cmake
file(GLOB files RELATIVE ${ADDON} ${ADDON}/citykiln/*.py ${ADDON}/citykiln/blender_manifest.toml)
list(SORT files COMPARE STRING)
set(rows "")
foreach(name ${files})
  file(READ ${ADDON}/${name} text)
  string(APPEND rows "{\"${name}\", R\"addon(${text})addon\"},\n")
endforeach()
file(WRITE ${OUT} "${rows}")
