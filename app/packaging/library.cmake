# Install rules of the library: archive or shared object, public headers, CMake package and pkg-config file.
include(CMakePackageConfigHelpers)

# install_library(KIND [EXCLUDE_FROM_ALL]): forefront_core or forefront_shared, as the component of that name.
function(install_library KIND)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Forefront)
  set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${KIND})
  get_target_property(type ${KIND} TYPE)
  # Programs that link the static library also link what it uses; the shared one has loaded that by itself.
  set(REQUIRES_FIELD Requires.private)
  set(CMAKE_REQUIRES "")
  if(type STREQUAL STATIC_LIBRARY)
    set(REQUIRES_FIELD Requires)
    set(CMAKE_REQUIRES ${FOREFRONT_REQUIRES})
  endif()
  list(JOIN FOREFRONT_REQUIRES ", " PC_REQUIRES)
  set(PC_CFLAGS $<$<BOOL:${FOREFRONT_EXPORT_FP_CONTRACT}>: -ffp-contract=off>)
  # Relative to the file itself, so that the installed tree can be moved.
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${pc_folder}
             OUTPUT_VARIABLE PC_PREFIX)
  set(templates ${PROJECT_SOURCE_DIR}/app/packaging)
  configure_package_config_file(${templates}/ForefrontConfig.cmake.in ${generated}/ForefrontConfig.cmake
                                INSTALL_DESTINATION ${package_folder})
  # Before 1.0 each minor version may change the interface.
  write_basic_package_version_file(${generated}/ForefrontConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  configure_file(${templates}/forefront.pc.in ${generated}/forefront.pc.configured @ONLY)
  file(GENERATE OUTPUT ${generated}/forefront.pc INPUT ${generated}/forefront.pc.configured)

  install(TARGETS ${KIND} EXPORT ${KIND}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${KIND} ${ARGN}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${KIND} ${ARGN})
  install(EXPORT ${KIND} FILE ${KIND}.cmake NAMESPACE Forefront:: DESTINATION ${package_folder}
          COMPONENT ${KIND} ${ARGN})
  install(FILES ${generated}/ForefrontConfig.cmake ${generated}/ForefrontConfigVersion.cmake
          DESTINATION ${package_folder} COMPONENT ${KIND} ${ARGN})
  install(FILES ${generated}/forefront.pc DESTINATION ${pc_folder} COMPONENT ${KIND} ${ARGN})
  install(DIRECTORY ${FOREFRONT_PUBLIC_INCLUDE}/forefront DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT ${KIND} ${ARGN})
endfunction()

foreach(kind IN LISTS kinds)
  if(kind STREQUAL FOREFRONT_LIBRARY)
    install_library(${kind})
  else()
    install_library(${kind} EXCLUDE_FROM_ALL)
  endif()
endforeach()
