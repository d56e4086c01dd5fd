#pragma once

#include "core/engine/mesh/measures.hpp"
#include "core/engine/session/snapshot.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/gl/mesh_order.hpp"
#include "ui/style/colour.hpp"
#include "ui/style/colour_map.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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
    Colour edge;             ///< transparent: none; faces coloured by value have edges that stand out on them
    double edgeWidth = 1.0;  ///< pixels, of elements at least twelve times as high; less where they are denser
    double denseEdges = 0.0; ///< opacity, relative to `edge`, of edges too dense to be distinguished
    ColourMap map = nullptr; ///< colours faces by their values, opaque; null: not coloured
    bool cyclic = false;     ///< the map repeats every eight values, for regions
    ColourRange range;       ///< of the values on the map
    double badBelow = -1e30; ///< parts with values below it are hatched
    double badAbove = 1e38;  ///< parts with values above it are hatched
    Colour hatch;
    double isolateFrom = 1.0, isolateTo = 0.0; ///< shows only parts with values in [from, to); from > to: all
};

/// A part of a mesh to draw, so that a large mesh can be drawn over several frames.
struct DrawSlice {
    std::size_t elements = 0; ///< maximum number to upload or draw; at least one chunk
    std::size_t first = 0;    ///< chunk to begin with; a draw sets it to the chunk to continue with
    bool more = false;        ///< set by a draw that left chunks
    bool waits = false;       ///< set, with `more`, by a draw that did nothing because the mesh is still being sorted
    std::size_t done = 0;     ///< increased by the number of elements uploaded or drawn
};

/// A mesh on the GPU: non-indexed triangles, drawn with their edges in one pass. It is divided into chunks, each with
/// its own origin for precision at any offset and zoom; chunks out of view are skipped. Chunks are uploaded when they
/// are first drawn, so that a slice limits that work too; the mesh of the last update supplies them. A mesh that grows
/// or shrinks at its end, as while the front advances, is updated in place.
class MeshBatch {
  public:
    /// `list`: of the window; a large mesh is sorted in the background.
    explicit MeshBatch(BackgroundList &list);
    ~MeshBatch();
    MeshBatch(const MeshBatch &) = delete;
    MeshBatch &operator=(const MeshBatch &) = delete;

    /// Sets the mesh; cheap if the version is the same. `atRest` means that the mesh will be shown for a while, so that
    /// sorting its chunks by location pays off; a large mesh is sorted on a separate thread. Without `values`, the
    /// elements are coloured by α. What `values` refers to must be alive in the draw that follows.
    void update(const std::shared_ptr<const MeshSnapshot> &view, bool atRest, const MeshValues *values = nullptr);
    std::size_t elements() const { return elements_; }
    /// Returns the number of elements uploaded by all draws together; for tests.
    std::size_t uploadedElements() const { return uploadedElements_; }
    /// Returns the number of chunks drawn by the last draw(); for tests.
    std::size_t chunksDrawn() const { return chunksDrawn_; }
    /// Returns the bytes that the batch takes up here and in buffers of OpenGL, without the mesh.
    std::size_t bytes() const;
    /// `slice`: the part to draw; null: all, even if the mesh has to be sorted first.
    void draw(const GlKit &gl, const Camera &camera, const MeshStyle &style, DrawSlice *slice = nullptr);

  private:
    struct Chunk {
        Vec2 origin;
        Box2 box; ///< of the elements; of those uploaded while `hasBox` is false
        bool hasBox = false;
        std::size_t first = 0, count = 0; ///< elements
        std::size_t corners = 0;          ///< elements whose corners are uploaded
        std::size_t values = 0;           ///< elements whose values are uploaded
    };
    struct Page;

    std::size_t commonPrefix(const MeshSnapshot &view) const;
    void truncate(std::size_t elements);
    void extend(const MeshSnapshot &view);
    void useOrder(MeshOrder order);
    std::size_t elementAt(std::size_t slot) const { return order_.empty() ? slot : order_[slot]; }
    Page &pageOf(const Chunk &chunk) { return *pages_[chunk.first / kPageElements]; }
    void makeRoom();
    void upload(Chunk &chunk);
    void uploadEdges(const Chunk &chunk);
    void uploadCorners(Chunk &chunk);
    void uploadValues(Chunk &chunk);
    const ShaderProgram &use(const GlKit &gl, const Camera &camera, const MeshStyle &style) const;

    static constexpr std::size_t kPageElements = 64 * kMeshChunk;

    BackgroundList &list_;
    std::shared_ptr<const MeshSnapshot> shown_;
    std::unique_ptr<MeshSorter> sorter_; ///< at work on `shown_`; null: not
    std::vector<Chunk> chunks_;
    std::vector<std::unique_ptr<Page>> pages_; ///< each holds kPageElements elements, the last one those that it needs
    std::vector<std::uint32_t> order_;         ///< elements in the order of the chunks; empty: their own
    std::optional<MeshValues> values_;         ///< of the last update; not set: α
    std::uint64_t valuesVersion_ = 0;
    std::size_t elements_ = 0;
    std::size_t uploadedElements_ = 0;
    std::size_t chunksDrawn_ = 0;
    bool byPlace_ = false;
};

} // namespace forefront
