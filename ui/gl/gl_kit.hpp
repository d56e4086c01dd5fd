#pragma once

#include "core/engine/domain/domain.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/gl/shader.hpp"
#include "ui/style/colour_map.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

class BackgroundList;
class MeshBatch;

/// A raster of ln ρ over a box, and the range of its colours.
struct FieldTint {
    Box2 box;
    int columns = 0, rows = 0;
    const std::vector<float> *logRho = nullptr;
    std::uint64_t version = 0;           ///< changes whenever the values change
    double minimum = 0.0, maximum = 1.0; ///< ln ρ at the ends of the map
    static constexpr std::size_t kMaxLevels = 8;
    std::vector<float> levels; ///< ln ρ of the contour lines in increasing order, kMaxLevels at most
    double contourWidth = 1.5; ///< pixels, at most
    double opacity = 1.0;      ///< of the colours over the plain one
};

/// Shader programs and textures that the layers share, one set per OpenGL context.
class GlKit {
  public:
    explicit GlKit(BackgroundList &list);
    ~GlKit();
    GlKit(const GlKit &) = delete;
    GlKit &operator=(const GlKit &) = delete;

    const ShaderProgram &lines() const { return lines_; }
    const ShaderProgram &boxes() const { return boxes_; }
    const ShaderProgram &mesh() const { return mesh_; }
    /// Returns the program for elements that have one colour and are all shown.
    const ShaderProgram &plainMesh() const { return plainMesh_; }
    const ShaderProgram &field() const { return field_; }
    /// Fills the domain with one colour, or with the colours of ρ if `tint` is not null.
    void drawField(const Domain &domain, std::uint64_t revision, const Camera &camera, Colour plain,
                   const FieldTint *tint);
    /// Sets the uniforms "centre" (split), "zoom" and "viewport" of the program in use.
    void setCamera(const ShaderProgram &program, const Camera &camera) const;
    /// Returns the elements of the mesh on the canvas, which two layers draw.
    MeshBatch &elements() { return *elements_; }
    /// Returns a texture of 256 x 2 texels: the colours of a map, and those of edges over them.
    unsigned map(ColourMap colours) const;
    /// Returns a vertex array without attributes, for shaders that compute their own corners.
    unsigned emptyArray() const { return emptyArray_; }

  private:
    ShaderProgram lines_, boxes_, mesh_, plainMesh_, field_, plainField_;
    std::unique_ptr<MeshBatch> elements_;
    void updateMask(const Domain &domain, std::uint64_t revision, const Camera &camera);
    void updateRaster(const FieldTint &tint);

    unsigned spacing_ = 0, emptyArray_ = 0, mask_ = 0, raster_ = 0;
    mutable std::vector<std::pair<ColourMap, unsigned>> maps_; ///< made when first used
    std::uint64_t maskRevision_ = 0, rasterVersion_ = 0;
    Camera maskCamera_;
};

} // namespace forefront
