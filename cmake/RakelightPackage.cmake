# The library as others use it: target Rakelight::rakelight by add_subdirectory() here and by find_package(Rakelight) after
# the installation. The modules are installed as static libraries of their own; consumers see the one target.
include(CMakePackageConfigHelpers)

add_library(rakelight_library INTERFACE)
add_library(Rakelight::rakelight ALIAS rakelight_library)
set_target_properties(rakelight_library PROPERTIES EXPORT_NAME rakelight)
target_link_libraries(rakelight_library INTERFACE rakelight_tools)
target_compile_features(rakelight_library INTERFACE cxx_std_20)
target_include_directories(rakelight_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

# Header-only libraries are no dependency of somebody who links.
get_property(modules GLOBAL PROPERTY RL_MODULES)
foreach(module IN LISTS modules)
  get_target_property(links ${module} INTERFACE_LINK_LIBRARIES)
  if(links)
    list(REMOVE_ITEM links "$<LINK_ONLY:nlohmann_json::nlohmann_json>")
    set_target_properties(${module} PROPERTIES INTERFACE_LINK_LIBRARIES "${links}")
  endif()
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Rakelight)
install(TARGETS rakelight_library ${modules} EXPORT RakelightTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT RakelightTargets NAMESPACE Rakelight:: DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/rakelight DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/include/rakelight/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rakelight)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/RakelightConfig.cmake.in ${PROJECT_BINARY_DIR}/RakelightConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RakelightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/RakelightConfig.cmake ${PROJECT_BINARY_DIR}/RakelightConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindOpenSubdiv.cmake DESTINATION ${package_dir})

if(RAKELIGHT_TESTS)
  add_test(NAME consumer
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR}/tests/consumer
      -DCOMPILER=${CMAKE_CXX_COMPILER} -DGENERATOR=${CMAKE_GENERATOR} -DSANITIZE=${RAKELIGHT_SANITIZE}
      -DVERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/tests/consumer/install_and_use.cmake)
  set_tests_properties(consumer PROPERTIES LABELS slow TIMEOUT 600)
endif()
