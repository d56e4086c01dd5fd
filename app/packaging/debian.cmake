# Debian packages by CPack: sh app/package.sh. Which install components make up a package, and its control file.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_NAME forefront)
set(CPACK_PACKAGE_CONTACT "The Forefront authors <maintainers@forefront.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The drawing library links the engine, which is in the same package.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/finish.cmake)
set(control ${CMAKE_CURRENT_LIST_DIR}/debian)
set(minor ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(same_version "(= ${PROJECT_VERSION})")

# debian_package(GROUP NAME SECTION SUMMARY TEXT COMPONENT...): a package of these install components. CPack names its
# variables by the group.
macro(debian_package GROUP NAME SECTION SUMMARY TEXT)
  string(TOUPPER ${GROUP} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${NAME})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${SECTION})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${SUMMARY}\n${TEXT}")
  list(APPEND CPACK_COMPONENTS_ALL ${ARGN} ${GROUP}_doc)
  install(FILES ${control}/copyright ${control}/changelog DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${NAME}
          COMPONENT ${GROUP}_doc EXCLUDE_FROM_ALL)
  foreach(component IN ITEMS ${ARGN} ${GROUP}_doc)
    set(CPACK_COMPONENT_${component}_GROUP ${GROUP})
    string(TOUPPER ${component} component)
    set(CPACK_COMPONENT_${component}_GROUP ${GROUP})
  endforeach()
endmacro()

set(about "Forefront fills planar domains with triangles or quadrilaterals by
the advancing front technique, and checks, converts and adapts meshes.
The same input gives the same mesh bit for bit.
")
set(CPACK_COMPONENTS_ALL "")
debian_package(
  program forefront science "Planar finite element meshes by the advancing front technique"
  "${about}
This package holds the program: commands for scripts, and the editor, in
which domains are drawn, element sizes set and runs watched step by step."
  program Unspecified) # what is installed without a component belongs to the program
# Loaded at run time, so no linked library tells: fonts by their files, the graphics driver by OpenGL.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
    "fonts-inter, fonts-dejavu-core, libgl1-mesa-dri, libegl-mesa0, libglx-mesa0, libgl1")
install(FILES ${CMAKE_CURRENT_LIST_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/forefront
        COMPONENT program_doc EXCLUDE_FROM_ALL)

debian_package(
  library libforefront${minor} libs "Planar finite element meshes, shared libraries"
  "${about}
This package holds the libraries that programs load: the mesher with its
files, and the one for drawings."
  forefront_shared_runtime forefront_drawing_shared_runtime)
install(FILES ${control}/library/overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
        RENAME libforefront${minor} COMPONENT library_doc EXCLUDE_FROM_ALL)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${control}/library/triggers ${CMAKE_CURRENT_BINARY_DIR}/shlibs)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs
     "libforefront ${minor} libforefront${minor} (>= ${PROJECT_VERSION})\n"
     "libforefront-drawing ${minor} libforefront${minor} (>= ${PROJECT_VERSION})\n")

debian_package(
  development libforefront-dev libdevel "Planar finite element meshes, headers and CMake package"
  "${about}
This package holds what programs are built with: the headers for C++20
and C, the CMake package Forefront and the pkg-config files."
  forefront_shared forefront_drawing_shared)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libforefront${minor} ${same_version}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)

# The components that the program loads when a file needs them.
set(recommended "")
macro(debian_component NAME SUMMARY TEXT)
  if(TARGET forefront_component_${NAME})
    debian_package(${NAME} forefront-${NAME} science "${SUMMARY}" "${about}\n${TEXT}" forefront-${NAME})
    string(TOUPPER ${NAME} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "libforefront${minor} ${same_version} | forefront ${same_version}")
    list(APPEND recommended forefront-${NAME})
  endif()
endmacro()
debian_component(hdf5 "Planar finite element meshes in files of HDF5"
                 "This package holds the component that reads and writes XDMF files.")
debian_component(gdal "Planar finite element meshes of maps"
                 "This package holds the component that reads Shapefiles, GeoPackages,\nKML, FlatGeobuf and GeoTIFF.")
list(JOIN recommended ", " CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS)

if(TARGET forefront_python)
  debian_package(
    python python3-forefront python "Planar finite element meshes from Python"
    "${about}
This package holds the module for Python 3: meshes as NumPy arrays, sizes
as functions, runs step by step."
    python)
  # The module is built for one minor version of Python.
  math(EXPR next "${FOREFRONT_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${FOREFRONT_PYTHON_MINOR}~), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${control}/python/postinst ${control}/python/prerm)
endif()
include(CPack)
