# Converts the CSV file of published figures into a C++ source: cmake -DINPUT=... -DOUTPUT=... -P embed_tables.cmake
file(STRINGS "${INPUT}" lines)
set(rows "")
set(count 0)
set(header "table,mesh,rho_min,delta,grid,Nn,Ne,cpu_s,alpha,Nb,Nc,Ns,efficiency")
set(headerSeen OFF)
foreach(line IN LISTS lines)
  if(line MATCHES "^#" OR line STREQUAL "")
    continue()
  endif()
  if(NOT headerSeen)
    if(NOT line STREQUAL header)
      message(FATAL_ERROR "${INPUT}: the columns are '${line}', expected '${header}'")
    endif()
    set(headerSeen ON)
    continue()
  endif()
  set(number "([0-9.]+)")
  # CMake captures nine groups at most, so the numbers at the end are one group.
  if(NOT line MATCHES "^([0-9.]+),([0-9A-E]+),${number},${number},([a-z0-9]+),([0-9]+,[0-9]+,[0-9.]+,[0-9.]+,[0-9]+,[0-9.]*,[0-9.]+,[0-9.]+)$")
    message(FATAL_ERROR "${INPUT}: unexpected line '${line}'")
  endif()
  set(head "\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_2}\", ${CMAKE_MATCH_3}, ${CMAKE_MATCH_4}, \"${CMAKE_MATCH_5}\"")
  string(REPLACE ",," ", kNotPublished, " tail "${CMAKE_MATCH_6}")
  string(APPEND rows "    {${head}, ${tail}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from lo_tables.csv.
#include \"core/teaching/tables/published.hpp\"

#include <array>

namespace forefront {

std::span<const PublishedFigures> publishedFigures() {
    static constexpr std::array<PublishedFigures, ${count}> kFigures = {{
${rows}    }};
    return kFigures;
}

} // namespace forefront
")
