# Debian packages by CPack, one a component: `cmake --preset deb`, build, `cpack -G DEB --config build/deb/CPackConfig.cmake`.
# What Debian wants in every package (copyright, changelogs, compressed manuals, one time for all files) packages/debian/finish.cmake adds.
set(RAKELIGHT_MAINTAINER "Rakelight developers <rakelight@users.noreply.github.com>" CACHE STRING "Who answers for the Debian packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rakelight)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${RAKELIGHT_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RAKELIGHT_STRIP ${CMAKE_STRIP})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL "")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packages/debian/finish.cmake)
set(CPACK_RAKELIGHT_DEBIAN ${PROJECT_SOURCE_DIR}/packages/debian)
set(CPACK_RAKELIGHT_CHANGELOG ${PROJECT_SOURCE_DIR}/CHANGELOG.md)

# rl_deb(COMPONENT PACKAGE SECTION DESCRIPTION DEPENDS...): DEPENDS are components whose very version is needed.
macro(rl_deb component package section description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${description}")
  set(CPACK_COMPONENT_${upper}_DEPENDS ${ARGN})
endmacro()

set(what "Rakelight computes normals and tangents so that no seams show between the
objects of a model, and draws it by rasterization, OpenGL, ray tracing or path
tracing. It reads glTF, OBJ, PLY and, by a helper, FBX, DAE and others.")
rl_deb(programs rakelight graphics "renderer and attribute tool for 3D models of many parts
${what}
.
This package has the program rakelight, the helper for rare formats,
completions for shells, and thumbnails for file managers." library)
if(RAKELIGHT_VIEWER)
  rl_deb(viewer rakelight-view graphics "renderer for 3D models of many parts - viewer
${what}
.
This package has the viewer, rakelight-view." programs library)
  set(CPACK_DEBIAN_VIEWER_PACKAGE_RECOMMENDS "libegl1, libgl1, libgl1-mesa-dri")
endif()
rl_deb(library librakelight${RL_SOVERSION} libs "renderer for 3D models of many parts - shared library
${what}
.
This package has the shared library.")
rl_deb(attributes librakelight-attributes${RL_SOVERSION} libs "normals and tangents without seams for 3D models - shared library
${what}
.
This package has the shared library of normals and tangents alone, which needs
oneTBB and nothing else.")
rl_deb(development librakelight-dev libdevel "renderer for 3D models of many parts - development files
${what}
.
This package has headers, static libraries, and files for CMake and pkg-config." library attributes)
rl_deb(documentation rakelight-doc doc "renderer for 3D models of many parts - documentation
${what}
.
This package has the documentation and examples of programs that use the
library.")
if(RAKELIGHT_PYTHON)
  rl_deb(python python3-rakelight python "renderer for 3D models of many parts - Python module
${what}
.
This package has the module for Python, which gives and takes arrays of numpy." library programs)
  # The extension is for one version of Python.
  find_package(Python3 QUIET COMPONENTS Interpreter)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "libembree3-3, python3-tqdm, rakelight-doc")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packages/debian/python/postinst ${PROJECT_SOURCE_DIR}/packages/debian/python/prerm)
endif()

# Embree is loaded when it is asked for, OpenGL through libepoxy.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "rakelight-view, libembree3-3, libegl1, libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS rakelight-doc)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "libembree3-3, rakelight")
# For packages whose programs use the libraries: any later version with the same number in the soname.
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
foreach(name library=librakelight attributes=librakelight-attributes)
  string(REGEX MATCH "^([a-z]+)=(.*)$" matched ${name})
  set(control ${PROJECT_BINARY_DIR}/debian/${CMAKE_MATCH_1})
  file(WRITE ${control}/shlibs "${CMAKE_MATCH_2} ${RL_SOVERSION} ${CMAKE_MATCH_2}${RL_SOVERSION} (>= ${PROJECT_VERSION})\n")
  string(TOUPPER ${CMAKE_MATCH_1} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${control}/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
endforeach()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
# What the archives call, for those who link them.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libtbb-dev, libspng-dev, libjpeg-dev, libexpat1-dev, libopenexr-dev, libwebp-dev, libepoxy-dev, libdraco-dev, libmeshoptimizer-dev, libosd-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS pkg-config)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SHLIBDEPS OFF)
include(CPack)
