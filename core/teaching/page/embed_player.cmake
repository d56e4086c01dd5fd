# Converts NAME.html, NAME.css and NAME.js of a folder into a C++ source with the functions of a header:
# cmake -DFOLDER=... -DNAME=player -DHEADER=... -DOUTPUT=... [-DPARTS=FIRST.js;...] -P embed_player.cmake. The script is that of
# the parts, then NAME.js.
set(functions "")
foreach(part IN ITEMS Body:html Style:css Script:js)
  string(REPLACE ":" ";" words "${part}")
  list(GET words 0 name)
  list(GET words 1 extension)
  set(hex "")
  set(files "${NAME}.${extension}")
  if(extension STREQUAL "js")
    list(PREPEND files ${PARTS})
  endif()
  foreach(file IN LISTS files)
    file(READ "${FOLDER}/${file}" more HEX)
    string(APPEND hex "${more}")
  endforeach()
  # The bytes of UTF-8 as numbers: no text can end the literal or exceed the length that compilers accept.
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
  string(APPEND functions "std::string_view ${NAME}${name}() {
    static constexpr char kText[] = {${bytes}};
    return {kText, sizeof kText};
}
")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from ${NAME}.html, ${NAME}.css and ${NAME}.js.
#include \"${HEADER}\"

namespace forefront {

${functions}
} // namespace forefront
")
