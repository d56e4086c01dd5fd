# Finds the libraries of the editor by the names that they have in Debian, Fedora, Arch, vcpkg and Conan:
#
#   forefront_glfw    GLFW 3.3 or later
#   forefront_glm     GLM, headers only
#   forefront_imgui   Dear ImGui 1.86, or 1.91.4 or later, with imgui_stdlib, FreeType and the backend for OpenGL 3
#
# and how the loader of OpenGL 3.3 is made: by the program glad 2, in GLAD_PROGRAM, or else by the target forefront_glad_found.
find_package(PkgConfig QUIET)

# forefront_find(NAME WHAT ADVICE VERSION TARGETS... PACKAGES... PKG_CONFIG...): makes forefront_NAME of the first of the imported
# TARGETS that the CMake PACKAGES define, or of the first of the PKG_CONFIG modules. With neither, stops with ADVICE.
function(forefront_find NAME)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "WHAT;ADVICE;VERSION" "TARGETS;PACKAGES;PKG_CONFIG")
  add_library(forefront_${NAME} INTERFACE)
  foreach(package IN LISTS ARG_PACKAGES)
    find_package(${package} ${ARG_VERSION} CONFIG QUIET GLOBAL)
    foreach(target IN LISTS ARG_TARGETS)
      if(TARGET ${target})
        message(STATUS "${ARG_WHAT}: target ${target} of package ${package}")
        target_link_libraries(forefront_${NAME} INTERFACE ${target})
        return()
      endif()
    endforeach()
  endforeach()
  if(PKG_CONFIG_FOUND)
    string(TOUPPER FOREFRONT_${NAME} upper)
    pkg_search_module(${upper} QUIET IMPORTED_TARGET GLOBAL ${ARG_PKG_CONFIG})
    if(${upper}_FOUND)
      message(STATUS "${ARG_WHAT}: pkg-config ${${upper}_MODULE_NAME} ${${upper}_VERSION}")
      target_link_libraries(forefront_${NAME} INTERFACE PkgConfig::${upper})
      set(FOREFRONT_${NAME}_FOLDERS ${${upper}_INCLUDE_DIRS} PARENT_SCOPE)
      return()
    endif()
  endif()
  list(JOIN ARG_PACKAGES ", " packages)
  list(JOIN ARG_PKG_CONFIG ", " modules)
  message(FATAL_ERROR "${ARG_WHAT} not found: no CMake package ${packages}, no pkg-config module ${modules}; ${ARG_ADVICE}, "
                      "or leave the editor out with -DFOREFRONT_EDITOR=OFF")
endfunction()

forefront_find(glfw WHAT GLFW VERSION 3.3 ADVICE "install it (Debian: libglfw3-dev)" PACKAGES glfw3 glfw TARGETS glfw glfw::glfw glfw3
               PKG_CONFIG glfw3>=3.3)
forefront_find(glm WHAT GLM ADVICE "install it (Debian: libglm-dev)" PACKAGES glm TARGETS glm::glm glm PKG_CONFIG glm)
forefront_find(imgui WHAT "Dear ImGui" ADVICE "install it (Debian: libimgui-dev)" PACKAGES imgui TARGETS imgui::imgui imgui
               PKG_CONFIG imgui>=1.86)
target_compile_definitions(forefront_glfw INTERFACE GLFW_INCLUDE_NONE)

# The headers of the backends and of FreeType are beside imgui.h, or in folders of their own below it.
if(TARGET imgui::imgui)
  get_target_property(FOREFRONT_imgui_FOLDERS imgui::imgui INTERFACE_INCLUDE_DIRECTORIES)
endif()
foreach(header IN ITEMS imgui_impl_opengl3.h imgui_freetype.h imgui_stdlib.h)
  string(MAKE_C_IDENTIFIER FOREFRONT_${header} folder)
  find_path(${folder} ${header} HINTS ${FOREFRONT_imgui_FOLDERS}
            PATH_SUFFIXES imgui imgui/backends backends imgui/misc/freetype misc/freetype imgui/misc/cpp misc/cpp)
  mark_as_advanced(${folder})
  if(NOT ${folder})
    message(FATAL_ERROR "Dear ImGui has no ${header}; build it with OpenGL 3, FreeType and imgui_stdlib "
                        "(vcpkg: imgui[opengl3-binding,freetype])")
  endif()
  target_include_directories(forefront_imgui SYSTEM INTERFACE ${${folder}})
endforeach()

# glad 2 as a program that generates the loader, or as a library; version 1 has other names and is no use.
find_program(GLAD_PROGRAM glad)
if(NOT GLAD_PROGRAM)
  find_package(glad CONFIG QUIET GLOBAL)
  foreach(target IN ITEMS glad::glad glad)
    if(TARGET ${target} AND NOT TARGET forefront_glad_found)
      get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
      find_file(FOREFRONT_GLAD_HEADER glad/gl.h PATHS ${folders} NO_DEFAULT_PATH)
      mark_as_advanced(FOREFRONT_GLAD_HEADER)
      if(FOREFRONT_GLAD_HEADER)
        message(STATUS "glad: target ${target}")
        add_library(forefront_glad_found INTERFACE)
        target_link_libraries(forefront_glad_found INTERFACE ${target})
      endif()
    endif()
  endforeach()
  if(NOT TARGET forefront_glad_found)
    message(FATAL_ERROR "glad 2 not found, neither as a program nor as a CMake package with glad/gl.h; install it (Debian: "
                        "python3-glad, elsewhere: pip install glad2), or leave the editor out with -DFOREFRONT_EDITOR=OFF")
  endif()
endif()
