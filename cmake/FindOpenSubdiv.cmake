# OpenSubdiv's processor part: target OpenSubdiv::cpu. Debian's own CMake package names static libraries that it does not hold.
find_path(OpenSubdiv_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdiv_CPU_LIBRARY osdCPU)
mark_as_advanced(OpenSubdiv_INCLUDE_DIR OpenSubdiv_CPU_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdiv REQUIRED_VARS OpenSubdiv_CPU_LIBRARY OpenSubdiv_INCLUDE_DIR)
if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::cpu)
  add_library(OpenSubdiv::cpu UNKNOWN IMPORTED)
  set_target_properties(OpenSubdiv::cpu PROPERTIES IMPORTED_LOCATION ${OpenSubdiv_CPU_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenSubdiv_INCLUDE_DIR})
endif()
