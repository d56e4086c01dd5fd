# Writes the C++ source OUTPUT, which defines shaderText(name) for every file in SHADERS.
set(entries "")
foreach(path IN LISTS SHADERS)
  get_filename_component(name ${path} NAME_WE)
  file(READ ${path} text)
  string(APPEND entries "    if (name == \"${name}\") {\n        return R\"glsl(${text})glsl\";\n    }\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"ui/gl/shader.hpp\"\n\nnamespace forefront {\n
const char *shaderText([[maybe_unused]] std::string_view name) {\n${entries}    return nullptr;\n}\n
} // namespace forefront\n")
