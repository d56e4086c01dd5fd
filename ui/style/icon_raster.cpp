#include "ui/style/icon_raster.hpp"

#include "ui/style/icon_path.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

constexpr double kGrid = 20.0; ///< units along a side of an icon
constexpr double kStroke = 1.5, kHelper = 1.0, kFillOutline = 1.0;
constexpr double kHelperOpacity = 0.6;
constexpr double kDash = 1.6, kGap = 2.6;
constexpr double kNode = 1.6, kNodeCorner = 0.6; ///< half the side of a square, radius of its corners

double distanceToSegment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

bool isInside(const IconLine &line, glm::dvec2 p) {
    bool inside = false;
    for (std::size_t k = 0, before = line.size() - 1; k < line.size(); before = k++) {
        const glm::dvec2 a = line[before], b = line[k];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    return inside;
}

/// A picture of an icon being drawn. Distances are in units of the grid, negative inside a shape.
class IconPicture {
  public:
    explicit IconPicture(int size)
        : size_(size), pixels_(kGrid / size), cover_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

    void lines(const std::vector<IconLine> &lines, double width, double opacity) {
        const double half = 0.5 * std::max(width, kThinnest * pixels_);
        for (const IconLine &line : lines) {
            for (std::size_t k = 0; k + 1 < std::max<std::size_t>(line.size(), 2); ++k) {
                const glm::dvec2 a = line[k], b = line[std::min(k + 1, line.size() - 1)];
                paint(
                    {glm::min(a, b) - half, glm::max(a, b) + half},
                    [&](glm::dvec2 p) { return distanceToSegment(a, b, p) - half; }, opacity);
            }
        }
    }
    void areas(const std::vector<IconLine> &lines) {
        for (const IconLine &line : lines) {
            paint(
                {{0.0, 0.0}, {kGrid, kGrid}}, [&](glm::dvec2 p) { return isInside(line, p) ? -1.0 : 1.0; }, 1.0);
        }
        this->lines(lines, kFillOutline, 1.0); // smooths the edge and rounds the corners
    }
    void squares(const std::vector<double> &numbers) {
        for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) {
            const glm::dvec2 centre{numbers[k], numbers[k + 1]};
            paint(
                {centre - kNode, centre + kNode},
                [&](glm::dvec2 p) {
                    const glm::dvec2 out = glm::abs(p - centre) - (kNode - kNodeCorner);
                    return glm::length(glm::max(out, glm::dvec2(0.0))) + std::min(std::max(out.x, out.y), 0.0) -
                           kNodeCorner;
                },
                1.0);
        }
    }
    void discs(const std::vector<double> &numbers) {
        for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) {
            const glm::dvec2 centre{numbers[k], numbers[k + 1]};
            const double radius = numbers[k + 2];
            paint(
                {centre - radius, centre + radius}, [&](glm::dvec2 p) { return glm::distance(p, centre) - radius; },
                1.0);
        }
    }

    std::vector<std::uint8_t> coverage() const {
        std::vector<std::uint8_t> bytes(cover_.size());
        std::transform(cover_.begin(), cover_.end(), bytes.begin(),
                       [](double cover) { return static_cast<std::uint8_t>(std::lround(255.0 * cover)); });
        return bytes;
    }

  private:
    static constexpr double kThinnest = 1.0; ///< pixels; thinner lines fade

    /// The places that a shape may cover.
    struct Bounds {
        glm::dvec2 min, max;
    };

    /// Adds a shape given by the distance of a place from it. What covers a pixel more than the shape stays.
    template <class Distance>
    void paint(const Bounds &bounds, const Distance &distance, double opacity) {
        const auto pixel = [&](double place) { return std::clamp(static_cast<int>(place / pixels_), 0, size_ - 1); };
        for (int row = pixel(bounds.min.y - pixels_); row <= pixel(bounds.max.y + pixels_); ++row) {
            for (int column = pixel(bounds.min.x - pixels_); column <= pixel(bounds.max.x + pixels_); ++column) {
                const glm::dvec2 middle = pixels_ * glm::dvec2{column + 0.5, row + 0.5};
                double &cover = cover_[static_cast<std::size_t>(row * size_ + column)];
                cover = std::max(cover, opacity * std::clamp(0.5 - distance(middle) / pixels_, 0.0, 1.0));
            }
        }
    }

    int size_;
    double pixels_; ///< units per pixel
    std::vector<double> cover_;
};

} // namespace

std::vector<std::uint8_t> drawIcon(const IconShape &shape, IconPart part, int size) {
    IconPicture picture(size);
    if (part == IconPart::Whole) {
        picture.lines(flattenPath(shape.helper), kHelper, kHelperOpacity);
        picture.lines(dashesOf(flattenPath(shape.dashed), kDash, kGap), kStroke, 1.0);
        picture.lines(flattenPath(shape.stroke), kStroke, 1.0);
        picture.areas(flattenPath(shape.fill));
        picture.discs(numbersIn(shape.dots));
    }
    picture.squares(numbersIn(shape.nodes));
    return picture.coverage();
}

} // namespace forefront
