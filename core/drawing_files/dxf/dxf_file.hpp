#pragma once

#include "core/drawing_files/dxf/dxf_text.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// An entity of a DXF file: the part of the text with its groups, which are read when it is drawn.
struct DxfEntity {
    std::string_view type; ///< "LINE"
    std::size_t begin = 0; ///< the byte after its type
    std::size_t end = 0;
};

/// An entry of the table of layers.
struct DxfLayer {
    std::string name;
    bool frozen = false;
    bool off = false;
};

/// A block: entities that inserts draw as often as they like.
struct DxfBlock {
    Vec2 base;             ///< the point that comes to lie at the place of an insert
    bool external = false; ///< its content is in another file
    std::vector<DxfEntity> entities;
};

/// The structure of a DXF file.
struct DxfFile {
    DxfEncoding encoding;
    int units = 0;                          ///< $INSUNITS; 0: none
    std::size_t unitsOffset = 0;            ///< in the text
    std::map<std::string, DxfLayer> layers; ///< by name in lower case, in which names are compared
    std::map<std::string, DxfBlock> blocks; ///< likewise
    std::vector<DxfEntity> entities;        ///< of the model and, marked as such, of the paper space
};

/// Reads header, tables, blocks and the list of entities. Faults: bad-syntax with the line, cancelled.
Result<DxfFile> readDxfFile(const SourceText &source);

/// Returns a name as the keys of the maps above.
std::string dxfKey(const DxfFile &file, std::string_view name);

} // namespace forefront
