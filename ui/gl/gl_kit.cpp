#include "ui/gl/gl_kit.hpp"

#include "core/engine/base/assert.hpp"
#include "ui/gl/domain_mask.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/gl/split.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/edge_colour.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <span>

namespace forefront {

namespace {

unsigned smoothTexture(int filter) {
    unsigned texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

unsigned mapTexture(Colour (*map)(double)) {
    constexpr std::size_t kColours = 256;
    std::array<Colour, 2 * kColours> colours{};
    for (std::size_t i = 0; i < kColours; ++i) {
        colours[i] = map(static_cast<double>(i) / 255.0);
        colours[kColours + i] = edgeOn(colours[i]);
    }
    const unsigned texture = smoothTexture(GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, colours.data());
    return texture;
}

} // namespace

GlKit::GlKit(BackgroundList &list)
    : lines_("line"), boxes_("box"), mesh_("mesh"), plainMesh_("plain_mesh"), field_("field"),
      plainField_("plain_field", "field"), elements_(std::make_unique<MeshBatch>(list)),
      spacing_(mapTexture(spacingColour)) {
    glGenVertexArrays(1, &emptyArray_);
    mask_ = smoothTexture(GL_NEAREST);
    raster_ = smoothTexture(GL_LINEAR);
}

GlKit::~GlKit() {
    glDeleteTextures(1, &spacing_);
    for (const auto &[map, texture] : maps_) {
        glDeleteTextures(1, &texture);
    }
    glDeleteTextures(1, &mask_);
    glDeleteTextures(1, &raster_);
    glDeleteVertexArrays(1, &emptyArray_);
}

unsigned GlKit::map(ColourMap colours) const {
    for (const auto &[known, texture] : maps_) {
        if (known == colours) {
            return texture;
        }
    }
    return maps_.emplace_back(colours, mapTexture(colours)).second;
}

void GlKit::setCamera(const ShaderProgram &program, const Camera &camera) const {
    const SplitPoint centre(camera.centre);
    program.set("centreHigh", centre.high);
    program.set("centreLow", centre.low);
    program.set("zoom", static_cast<float>(camera.zoom));
    program.set("viewport", glm::vec2(camera.viewport.width, camera.viewport.height));
}

void GlKit::updateMask(const Domain &domain, std::uint64_t revision, const Camera &camera) {
    glBindTexture(GL_TEXTURE_2D, mask_);
    if (revision == maskRevision_ && camera == maskCamera_) {
        return;
    }
    maskRevision_ = revision;
    maskCamera_ = camera;
    const int width = static_cast<int>(camera.viewport.width), height = static_cast<int>(camera.viewport.height);
    const std::vector<std::uint8_t> mask = rasteriseDomain(domain, camera, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, mask.data());
}

void GlKit::updateRaster(const FieldTint &tint) {
    glBindTexture(GL_TEXTURE_2D, raster_);
    if (tint.version != rasterVersion_) {
        rasterVersion_ = tint.version;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, tint.columns, tint.rows, 0, GL_RED, GL_FLOAT, tint.logRho->data());
    }
}

void GlKit::drawField(const Domain &domain, std::uint64_t revision, const Camera &camera, Colour plain,
                      const FieldTint *tint) {
    const ShaderProgram &program = tint != nullptr ? field_ : plainField_;
    program.use();
    setCamera(program, camera);
    glActiveTexture(GL_TEXTURE0);
    updateMask(domain, revision, camera);
    program.set("mask", 0);
    program.set("plain", plain);
    if (tint != nullptr) {
        program.set("raster", 1);
        program.set("map", 2);
        glActiveTexture(GL_TEXTURE1);
        updateRaster(*tint);
        glActiveTexture(GL_TEXTURE2);
        glBindTexture(GL_TEXTURE_2D, spacing_);
        const Vec2 middle{0.5 * camera.viewport.width, 0.5 * camera.viewport.height};
        const Vec2 corner = middle + camera.zoom * (tint->box.min - camera.centre);
        program.set("rasterCorner", glm::vec2(corner.x, corner.y));
        const Vec2 size = camera.zoom * tint->box.size();
        program.set("rasterSize", glm::vec2(size.x, size.y));
        program.set("range", glm::vec2(tint->minimum, tint->maximum));
        FOREFRONT_ASSERT(tint->levels.size() <= FieldTint::kMaxLevels);
        std::array<float, FieldTint::kMaxLevels> levels;
        levels.fill(1e30F);
        std::copy(tint->levels.begin(), tint->levels.end(), levels.begin());
        program.set("levels", levels);
        program.set("contourWidth", static_cast<float>(tint->contourWidth));
        float gap = 1e30F;
        for (std::size_t k = 1; k < tint->levels.size(); ++k) {
            gap = std::min(gap, tint->levels[k] - tint->levels[k - 1]);
        }
        program.set("contourGap", gap);
        program.set("opacity", static_cast<float>(tint->opacity));
        glActiveTexture(GL_TEXTURE0);
    }
    glBindVertexArray(emptyArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace forefront
