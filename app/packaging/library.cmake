# Install rules of the libraries: archive or shared object, public headers, CMake package and pkg-config file.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Forefront)
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(templates ${PROJECT_SOURCE_DIR}/app/packaging)
list(JOIN FOREFRONT_REQUIRES ", " PC_PACKAGES)
set(PC_CFLAGS $<$<BOOL:${FOREFRONT_EXPORT_FP_CONTRACT}>: -ffp-contract=off>)
# Relative to the file itself, so that the installed tree can be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${pc_folder}
           OUTPUT_VARIABLE PC_PREFIX)
# Before 1.0 each minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/ForefrontConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)

# install_library(KIND NAME [EXCLUDE_FROM_ALL]): the library KIND that users link as Forefront::NAME, with its headers and
# its pkg-config file, as the component KIND; what programs need at run time is the component KIND_runtime.
function(install_library KIND NAME)
  get_target_property(PC_LIBRARY ${KIND} OUTPUT_NAME)
  get_target_property(type ${KIND} TYPE)
  # Programs that link the static library also link what it uses; the shared one loads that by itself, and its users need
  # no headers of it.
  set(PC_REQUIRES_LINE "")
  if(type STREQUAL STATIC_LIBRARY)
    set(PC_REQUIRES_LINE "Requires: ${PC_PACKAGES}")
  endif()
  if(NAME STREQUAL drawing)
    set(PC_REQUIRES_LINE "Requires: forefront = ${PROJECT_VERSION}")
  endif()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${KIND})
  configure_file(${templates}/forefront.pc.in ${generated}/${PC_LIBRARY}.pc.configured @ONLY)
  file(GENERATE OUTPUT ${generated}/${PC_LIBRARY}.pc INPUT ${generated}/${PC_LIBRARY}.pc.configured)

  install(TARGETS ${KIND} EXPORT ${KIND}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${KIND}_runtime NAMELINK_COMPONENT ${KIND} ${ARGN}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${KIND} ${ARGN})
  install(EXPORT ${KIND} FILE ${KIND}.cmake NAMESPACE Forefront:: DESTINATION ${package_folder}
          COMPONENT ${KIND} ${ARGN})
  install(FILES ${generated}/${PC_LIBRARY}.pc DESTINATION ${pc_folder} COMPONENT ${KIND} ${ARGN})
  install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/include/${NAME}/forefront DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT ${KIND} ${ARGN})
endfunction()

# install_package(KIND DRAWING_KIND [EXCLUDE_FROM_ALL]): the files by which CMake finds the libraries, in the component of
# the engine.
function(install_package KIND DRAWING_KIND)
  get_target_property(type ${KIND} TYPE)
  set(CMAKE_REQUIRES "")
  if(type STREQUAL STATIC_LIBRARY)
    set(CMAKE_REQUIRES ${FOREFRONT_REQUIRES})
  endif()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${KIND})
  configure_package_config_file(${templates}/ForefrontConfig.cmake.in ${generated}/ForefrontConfig.cmake
                                INSTALL_DESTINATION ${package_folder})
  install(FILES ${generated}/ForefrontConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ForefrontConfigVersion.cmake
          DESTINATION ${package_folder} COMPONENT ${KIND} ${ARGN})
endfunction()

install_library(${FOREFRONT_LIBRARY} core)
install_package(${FOREFRONT_LIBRARY} ${FOREFRONT_DRAWING_LIBRARY})
install_library(${FOREFRONT_DRAWING_LIBRARY} drawing)
if(FOREFRONT_BOTH_KINDS AND NOT BUILD_SHARED_LIBS)
  install_library(forefront_shared core EXCLUDE_FROM_ALL)
  install_package(forefront_shared forefront_drawing_shared EXCLUDE_FROM_ALL)
  install_library(forefront_drawing_shared drawing EXCLUDE_FROM_ALL)
endif()
