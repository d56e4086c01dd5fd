#pragma once

#include "core/mesh/measures.hpp"
#include "core/session/snapshot.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/style/colour.hpp"
#include "ui/style/colour_map.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace forefront {

class GlKit;

/// The values that colour a mesh, one for each of its elements, edges or nodes. Edges and nodes colour the parts of the
/// elements that are nearest to them.
struct MeshValues {
    MeshPart part = MeshPart::Elements;
    std::span<const double> values;
    const MeshEdges *edges = nullptr; ///< of the mesh, for values of edges
    bool smooth = false;              ///< values of nodes are interpolated, with contour lines
    bool logarithmic = false;         ///< the map shows the logarithms of the values
    /// Identifies the values, which are uploaded again when it changes.
    std::uint64_t version = 0;
};

/// The style in which the elements of a mesh are drawn.
struct MeshStyle {
    Colour face;             ///< of elements not coloured by their value; transparent: none
    Colour edge;             ///< transparent: none
    double edgeWidth = 1.0;  ///< pixels
    double denseEdges = 0.0; ///< opacity, relative to `edge`, of edges too dense to be distinguished
    ColourMap map = nullptr; ///< colours faces by their values, opaque; null: not coloured
    bool cyclic = false;     ///< the map repeats every eight values, for regions
    ColourRange range;       ///< of the values on the map
    double badBelow = -2.0;  ///< elements with values below it are hatched
    Colour hatch;
    double isolateFrom = 1.0, isolateTo = 0.0; ///< shows only parts with values in [from, to); from > to: all
};

/// A part of a mesh to draw, so that a large mesh can be drawn over several frames.
struct DrawSlice {
    std::size_t elements = 0; ///< maximum number to draw; at least one chunk is drawn
    std::size_t first = 0;    ///< chunk to begin with; a draw sets it to the chunk to continue with
    bool more = false;        ///< set by a draw that left chunks
};

/// A mesh on the GPU: non-indexed triangles, drawn with their edges in one pass. It is divided into chunks, each with
/// its own origin for precision at any offset and zoom; chunks out of view are skipped. A mesh that grows or shrinks at
/// its end, as while the front advances, is updated in place.
class MeshBatch {
  public:
    MeshBatch();
    ~MeshBatch();
    MeshBatch(const MeshBatch &) = delete;
    MeshBatch &operator=(const MeshBatch &) = delete;

    /// Uploads what has changed; cheap if the version is the same. `atRest` means that the mesh will be shown for a
    /// while, so that sorting its chunks by location pays off. Without `values`, the elements are coloured by α.
    void update(const std::shared_ptr<const MeshView> &view, bool atRest, const MeshValues *values = nullptr);
    std::size_t elements() const { return uploaded_; }
    /// Returns the number of elements uploaded by all updates together; for tests.
    std::size_t sent() const { return sent_; }
    /// Returns the number of chunks drawn by the last draw(); for tests.
    std::size_t chunksDrawn() const { return chunksDrawn_; }
    /// `slice`: the part to draw; null: all.
    void draw(const GlKit &gl, const Camera &camera, const MeshStyle &style, DrawSlice *slice = nullptr);

  private:
    struct Chunk {
        Vec2 origin;
        Box2 box;
        std::size_t first = 0, count = 0; ///< elements
    };

    std::size_t commonPrefix(const MeshView &view) const;
    void truncate(std::size_t elements);
    void appendInOrder(const MeshView &view, std::size_t from);
    void rebuildByPlace(const MeshView &view);
    void writeElement(const MeshView &view, std::size_t element, Chunk &chunk);
    /// Returns the number of elements in the buffers.
    std::size_t slots() const { return order_.empty() ? corners_.size() / 3 : order_.size(); }
    std::size_t elementAt(std::size_t slot) const { return order_.empty() ? slot : order_[slot]; }
    void writeValues(const MeshView &view, const MeshValues *values, std::size_t fromElement);
    void upload(std::size_t fromElement, std::size_t fromValue);

    std::shared_ptr<const MeshView> shown_;
    std::vector<Chunk> chunks_;
    std::vector<glm::vec2> corners_;   ///< three per element, relative to the origin of the chunk; empty if sorted
    std::vector<float> values_;        ///< three per element, from entry kSkip on; empty if sorted
    std::vector<std::uint32_t> order_; ///< elements in the order of the buffers; empty: their own
    std::uint64_t valuesVersion_ = 0;
    MeshPart part_ = MeshPart::Elements;
    bool logarithmic_ = false, smooth_ = false;
    std::size_t uploaded_ = 0; ///< elements
    std::size_t capacity_ = 0; ///< elements that fit into the buffers
    std::size_t sent_ = 0;
    std::size_t chunksDrawn_ = 0;
    bool byPlace_ = false;
    unsigned array_ = 0, cornerBuffer_ = 0, valueBuffer_ = 0;
};

} // namespace forefront
