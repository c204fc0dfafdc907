# Compiles through ccache where it is installed and can keep something: without a cache folder that
# it may write (a user without a home, a read-only one) ccache stops the build.
find_program(G31_CCACHE ccache)
if(G31_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  execute_process(COMMAND ${G31_CCACHE} --get-config cache_dir
    OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${CMAKE_COMMAND} -E make_directory "${folder}/tmp"
    RESULT_VARIABLE refused ERROR_QUIET)
  if(folder AND NOT refused)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${G31_CCACHE})
  endif()
endif()
