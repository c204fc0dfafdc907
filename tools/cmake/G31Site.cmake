# The manual as pages for a browser, on request: cmake --build build/release --target g31_site
find_program(G31_MKDOCS mkdocs)
if(G31_MKDOCS)
  add_custom_target(g31_site
    COMMAND ${G31_MKDOCS} build --strict --site-dir ${PROJECT_BINARY_DIR}/site
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "The manual: ${PROJECT_BINARY_DIR}/site/index.html")
else()
  message(STATUS "No mkdocs (Debian: mkdocs): the manual is not built as a site")
endif()
