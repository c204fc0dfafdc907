# CPack reads this for each kind of package: a Debian package lies in /usr and names the libraries that it needs,
# an archive brings them and lies wherever it is unpacked.
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
else()
  set(CPACK_PACKAGING_INSTALL_PREFIX "")
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  list(APPEND CPACK_COMPONENTS_ALL libraries)
endif()
