# The files that are installed besides the program and its modules, and the Debian package of it all: `cpack -G DEB` in
# a build folder writes citykiln_<version>_<architecture>.deb there.
set(share ${CMAKE_INSTALL_DATADIR}/citykiln)
find_program(GZIP gzip REQUIRED)

# install_packed(FILE DESTINATION NAME) installs a file packed by gzip, without its time.
function(install_packed file destination name)
  install(CODE "
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${destination}\")
    file(MAKE_DIRECTORY \"\${folder}\")
    execute_process(COMMAND ${GZIP} -9nc \"${file}\" OUTPUT_FILE \"\${folder}/${name}.gz\" COMMAND_ERROR_IS_FATAL ANY)
  ")
endfunction()

# ---- the manual pages and the completion of bash, printed by the program from its tables of options -------------------
add_custom_command(TARGET citykiln POST_BUILD VERBATIM
                   COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/man
                   COMMAND citykiln man -o ${PROJECT_BINARY_DIR}/man
                   COMMAND citykiln completion > ${PROJECT_BINARY_DIR}/citykiln.bash)
install(CODE "
  file(GLOB pages \"${PROJECT_BINARY_DIR}/man/*.1\")
  set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
  file(MAKE_DIRECTORY \"\${folder}\")
  foreach(page IN LISTS pages)
    get_filename_component(name \"\${page}\" NAME)
    execute_process(COMMAND ${GZIP} -9nc \"\${page}\" OUTPUT_FILE \"\${folder}/\${name}.gz\" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
")
install(FILES ${PROJECT_BINARY_DIR}/citykiln.bash RENAME citykiln
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

# ---- the example town: its settings name files by their installed place ----------------------------------------------
# Not below share/doc, which small Debian images leave out.
set(town ${PROJECT_SOURCE_DIR}/examples/town)
install(FILES ${town}/town.osm ${town}/town_heights.png ${town}/drive.geojson DESTINATION ${share}/examples/town)
install(CODE "
  file(READ \"${town}/spec.json\" spec)
  set(installed \"\${CMAKE_INSTALL_PREFIX}/${share}/examples/town\")
  string(REPLACE examples/town \"\${installed}\" spec \"\${spec}\")
  file(WRITE \"\$ENV{DESTDIR}\${installed}/spec.json\" \"\${spec}\")
")

# ---- add-ons for programs that read the tiles ------------------------------------------------------------------------
install(DIRECTORY exporters/godot/godot3 exporters/godot/godot4 DESTINATION ${share})
# Blender installs add-ons from zip files
install(CODE "
  file(GLOB sources RELATIVE \"${PROJECT_SOURCE_DIR}/exporters/blender\" \"${PROJECT_SOURCE_DIR}/exporters/blender/citykiln/*.py\")
  if(sources)
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${share}/blender\")
    file(MAKE_DIRECTORY \"\${folder}\")
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E tar cf \"\${folder}/citykiln.zip\" --format=zip --mtime=2026-01-01 \${sources}
      WORKING_DIRECTORY \"${PROJECT_SOURCE_DIR}/exporters/blender\" COMMAND_ERROR_IS_FATAL ANY)
  endif()
")

# ---- licence and changes ---------------------------------------------------------------------------------------------
install(FILES package/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install_packed(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${CMAKE_INSTALL_DOCDIR} changelog)
install_packed(${PROJECT_SOURCE_DIR}/package/changelog.Debian ${CMAKE_INSTALL_DOCDIR} changelog.Debian)
# Debian has the text of the licence itself, so the package leaves out this component
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)

# ---- the package -----------------------------------------------------------------------------------------------------
set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};citykiln;Unspecified;/")
set(CPACK_PACKAGE_CONTACT "citykiln maintainers <maintainers@citykiln.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# the libraries that program and modules are linked to, found by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "blender, godot3, qgis")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "compiles OpenStreetMap extracts and heightmaps to 3D city tiles
citykiln works offline. It writes glTF, USD and 3D Tiles with levels of detail
whose largest geometric error is measured and stated, and a compact manifest
from which every tile can be made again, byte for byte.")
include(CPack)
