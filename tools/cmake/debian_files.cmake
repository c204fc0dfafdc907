# CPack calls this on the tree of a package before it packs it.  A Debian package says under which licence it comes in
# a file of its own form, has a list of changes, and both that and its pages are compressed, without a time in them.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
file(GLOB docs "${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/g31" "${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/doc/g31")
foreach(doc ${docs})
  file(REMOVE "${doc}/LICENSE")
  file(WRITE "${doc}/copyright" "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: g31

Files: *
Copyright: 2026 the g31 maintainers
License: Apache-2.0
 On Debian systems the whole text of the Apache License, version 2.0, is in
 /usr/share/common-licenses/Apache-2.0.
")
  file(WRITE "${doc}/changelog" "g31 (${CPACK_PACKAGE_VERSION}) unstable; urgency=low

  * What it does is in README.md and docs/.

 -- ${CPACK_PACKAGE_CONTACT}  Sun, 22 Nov 2026 00:00:00 +0000
")
  file(GLOB pages "${doc}/../../man/man1/*.1")
  execute_process(COMMAND gzip -9n "${doc}/changelog" ${pages} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
