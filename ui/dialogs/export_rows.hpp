#pragma once

#include "core/engine/session/snapshot.hpp"
#include "core/files/format_list.hpp"
#include "core/files/inner_edges.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

struct Document;
struct Shell;

/// What the user chooses of a mesh that is exported.
struct ExportChoice {
    InnerEdges innerEdges = InnerEdges::Keep;
    std::map<std::int32_t, std::string> open; ///< parts through which water flows: names by tag
    std::string elevation;                    ///< of the nodes, an expression; empty: none
};

/// The rows of the export dialog below the name of the file: what the chosen format keeps of the mesh and asks about
/// it. The open boundary parts and the elevation begin as the document has them.
class ExportRows {
  public:
    explicit ExportRows(const Document &document);

    /// Draws the rows for a format and a finished mesh.
    void draw(Shell &context, const FileFormat &format, const std::shared_ptr<const MeshSnapshot> &mesh);
    /// Returns the number of lines that draw() needs for a format.
    int lines(const FileFormat &format) const;
    /// Returns what has been chosen, as far as a format takes it.
    ExportChoice choice(const FileFormat &format) const;
    /// Remembers the open parts and the elevation that a format takes with the document, as one command if they differ.
    void keep(Shell &context, const FileFormat &format) const;

  private:
    void look(const std::shared_ptr<const MeshSnapshot> &mesh);
    void drawNames(Shell &context, const FileFormat &format) const;
    void drawInnerEdges(Shell &context, const FileFormat &format);
    void drawOpenParts(Shell &context);
    void drawElevation(Shell &context, const FileFormat &format);
    void enterElevation(Shell &context, const std::string &typed);
    bool anyOpen() const;

    bool innerEdges_ = true;
    std::vector<std::int32_t> open_; ///< tags; also those that the mesh lacks
    std::string elevation_;
    std::shared_ptr<const MeshSnapshot> mesh_; ///< whose parts these are
    std::map<std::int32_t, std::string> boundary_, regions_;
};

} // namespace forefront
