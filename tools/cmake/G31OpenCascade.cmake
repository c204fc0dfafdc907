# Open CASCADE, which reads STEP, as the target open_cascade for the module g31_step; no target where it is
# not installed, and then g31 says so when a STEP file comes.
# Its own package file wants the viewer and the draw tools as well.
find_path(G31_OCCT_HEADERS STEPControl_Reader.hxx PATH_SUFFIXES opencascade)
set(found ${G31_OCCT_HEADERS})
set(libraries)
foreach(toolkit
    TKSTEP TKSTEPAttr TKSTEPBase TKXSBase TKMesh TKBool TKBO TKShHealing TKPrim TKTopAlgo TKGeomAlgo TKGeomBase TKBRep
    TKG3d TKG2d TKMath TKernel)
  find_library(G31_OCCT_${toolkit} ${toolkit})
  list(APPEND libraries ${G31_OCCT_${toolkit}})
  if(NOT G31_OCCT_${toolkit})
    set(found OFF)
  endif()
endforeach()
if(found)
  add_library(open_cascade INTERFACE)
  target_include_directories(open_cascade SYSTEM INTERFACE ${G31_OCCT_HEADERS})
  target_link_libraries(open_cascade INTERFACE ${libraries})
else()
  message(STATUS "No Open CASCADE (Debian: libocct-data-exchange-dev): STEP files are not read")
endif()
