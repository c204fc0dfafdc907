# What `cmake --install` and CPack bring: a tree that can be moved, for the program finds what comes with it from
# where it lies itself.
#
#   cmake --install build/release --prefix ~/.local
#   cpack --config build/release/CPackConfig.cmake -G DEB -B build/packages    (or -G TGZ)
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)

# What programs and sheets name, and explain reads.
install(DIRECTORY macros DESTINATION share/g31 USE_SOURCE_PERMISSIONS)
install(DIRECTORY machine/library DESTINATION share/g31/machine USE_SOURCE_PERMISSIONS)
install(DIRECTORY parts/library DESTINATION share/g31/parts USE_SOURCE_PERMISSIONS
  PATTERN make_specimen.py EXCLUDE)  # what it makes is there
install(DIRECTORY docs DESTINATION share/doc/g31 OPTIONAL)
install(FILES README.md DESTINATION share/doc/g31)
install(FILES LICENSE DESTINATION share/doc/g31)

set(g31_modules lib/g31/modules)
install(TARGETS g31 RUNTIME_DEPENDENCY_SET g31_needs RUNTIME DESTINATION bin)
get_property(module_targets GLOBAL PROPERTY g31_module_targets)
install(TARGETS ${module_targets} RUNTIME_DEPENDENCY_SET g31_needs LIBRARY DESTINATION ${g31_modules})
# The archive brings the libraries, too, all but those of the language: built on Debian 12 it runs there, on
# Ubuntu 22.04 and whatever came later (glibc 2.35, libstdc++ 6.0.30).
install(RUNTIME_DEPENDENCY_SET g31_needs
  PRE_EXCLUDE_REGEXES "^(ld-linux|libc\\.|libm\\.|libgcc_s|libstdc)"
  DESTINATION ${g31_modules} COMPONENT libraries EXCLUDE_FROM_ALL)

# Completions and pages of the manual are the program's own words.
install(CODE "
  execute_process(COMMAND \"${CMAKE_COMMAND}\"
    -D \"PREFIX=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" -P \"${CMAKE_CURRENT_LIST_DIR}/write_pages.cmake\"
    COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)

set(CPACK_PACKAGE_NAME g31)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR g31)
set(CPACK_PACKAGE_CONTACT "g31 maintainers <g31@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "runs touch-probe NC programs on a simulated machine tool")
set(CPACK_PACKAGE_DESCRIPTION "FANUC Custom Macro B and SINUMERIK 828D programs with measuring cycles run
as they are, on a simulated machine whose skip moves end where the stylus
ball meets the mesh of the workpiece: same motions, variables and alarms.")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS librsvg2-bin)  # g31 scene -o FILE.png
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/package_kinds.cmake")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake")
set(CPACK_GENERATOR DEB TGZ)
include(CPack)
