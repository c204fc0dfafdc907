# cmake -DFROM=SOURCE -DTO=FOLDER -DNPM=npm -P install_packages.cmake
#
# Puts the packages that SOURCE's lock file names into FOLDER/node_modules.  npm's own words come only when it fails.
file(MAKE_DIRECTORY ${TO})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json ${FROM}/.npmrc DESTINATION ${TO})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund
  WORKING_DIRECTORY ${TO} RESULT_VARIABLE refused OUTPUT_VARIABLE words ERROR_VARIABLE words)
if(refused)
  message(FATAL_ERROR "${words}\nThe packages of the report page could not be fetched.  To build without the page's "
    "script: cmake -DG31_PAGE=OFF")
endif()
file(TOUCH ${TO}/installed.stamp)
