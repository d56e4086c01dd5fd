#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/mesher/trace.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// Texts, each of which is written once and referred to by its number.
class WordList {
  public:
    std::uint32_t add(const std::string &text);
    const std::vector<std::string> &words() const { return words_; }

  private:
    std::vector<std::string> words_;
    std::map<std::string, std::uint32_t> numbers_;
};

/// Writes the numbers of a run as JSON, short: places with eight digits, shares with four.
class RunRecord {
  public:
    explicit RunRecord(TextWriter &out) : out_(out) {}

    /// Writes the co-ordinates of nodes: [x, y, x, y, ...].
    void nodes(std::span<const Vec2> nodes);
    /// Writes the tagged edges of a mesh as pairs of nodes: [a, b, a, b, ...].
    void edges(const MeshView &mesh);
    /// Writes the corners of all elements of a mesh, `width` numbers for each: [a, b, c, ...]; of four numbers, the
    /// last of a triangle is -1.
    void cells(const MeshView &mesh, unsigned width);
    /// Writes an advance as an object, without its number. `triangles`: made by the front; `words`: receives its
    /// captions.
    void advance(const AdvanceExplanation &advance, std::span<const Element> triangles, WordList &words);
    /// Writes the triangles that an advance made in place of the advance: [a, b, c, ...].
    void elements(const AdvanceExplanation &advance, std::span<const Element> triangles);

  private:
    TextWriter &out_;
};

} // namespace forefront
