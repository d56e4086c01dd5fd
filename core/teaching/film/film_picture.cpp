#include "core/teaching/film/film_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace forefront {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr int kSamples = 2; ///< per pixel and direction
constexpr int kShades = 6;  ///< levels of each of red, green and blue in the palette

/// A picture of kSamples² samples for each pixel.
class SamplePicture {
  public:
    SamplePicture(int width, int height)
        : width_(width * kSamples), height_(height * kSamples),
          samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Ink::Paper) {}

    void triangle(Vec2 a, Vec2 b, Vec2 c, Ink ink) {
        if (cross(b - a, c - a) < 0.0) {
            std::swap(b, c);
        }
        const int top = row(std::min({a.y, b.y, c.y})), bottom = row(std::max({a.y, b.y, c.y}));
        const int left = column(std::min({a.x, b.x, c.x})), right = column(std::max({a.x, b.x, c.x}));
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                const Vec2 p{(x + 0.5) / kSamples, (y + 0.5) / kSamples};
                if (cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0) {
                    at(x, y) = ink;
                }
            }
        }
    }

    /// Fills a polygon of any shape: a sample is inside if an odd number of its sides pass to the right of it.
    void polygon(std::span<const Vec2> corners, Ink ink) {
        Box2 box;
        for (const Vec2 corner : corners) {
            box.add(corner);
        }
        for (int y = row(box.min.y); y <= row(box.max.y); ++y) {
            for (int x = column(box.min.x); x <= column(box.max.x); ++x) {
                if (isInside(corners, {(x + 0.5) / kSamples, (y + 0.5) / kSamples})) {
                    at(x, y) = ink;
                }
            }
        }
    }

    void line(const FilmLine &line) {
        const double half = 0.5 * line.width;
        if (line.a == line.b) {
            dot(line.a, half, line.ink);
            return;
        }
        const Vec2 along = (half / distance(line.a, line.b)) * (line.b - line.a), side{-along.y, along.x};
        triangle(line.a - side, line.b - side, line.b + side, line.ink);
        triangle(line.a - side, line.b + side, line.a + side, line.ink);
        dot(line.b, half, line.ink); // round ends hide the gaps at corners
    }

    void circle(const FilmCircle &circle) {
        constexpr int kCorners = 96;
        const auto corner = [&](int k) {
            const double angle = 2.0 * std::numbers::pi * k / kCorners;
            return circle.centre + circle.radius * Vec2{std::cos(angle), std::sin(angle)};
        };
        for (int k = 0; k < kCorners; ++k) {
            line({corner(k), corner(k + 1), circle.ink, circle.width});
        }
    }

    void rectangle(Vec2 a, Vec2 b, Ink ink) {
        triangle(a, {b.x, a.y}, b, ink);
        triangle(a, b, {a.x, b.y}, ink);
    }

    /// Returns the mean colour of the samples of a pixel.
    Rgb pixel(int x, int y) const {
        std::array<int, 3> sum{};
        for (int k = 0; k < kSamples * kSamples; ++k) {
            const Rgb colour = rgbOf(samples_[place(x * kSamples + k % kSamples, y * kSamples + k / kSamples)]);
            for (std::size_t i = 0; i < 3; ++i) {
                sum[i] += colour[i];
            }
        }
        Rgb mean{};
        std::transform(sum.begin(), sum.end(), mean.begin(),
                       [](int s) { return static_cast<std::uint8_t>(s / (kSamples * kSamples)); });
        return mean;
    }

  private:
    void dot(Vec2 centre, double radius, Ink ink) {
        constexpr int kCorners = 12;
        const auto corner = [&](int k) {
            const double angle = 2.0 * std::numbers::pi * k / kCorners;
            return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
        };
        for (int k = 0; k < kCorners; ++k) {
            triangle(centre, corner(k), corner(k + 1), ink);
        }
    }
    static bool isInside(std::span<const Vec2> corners, Vec2 p) {
        bool inside = false;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k], b = corners[(k + 1) % corners.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
                inside = !inside;
            }
        }
        return inside;
    }
    int row(double y) const { return std::clamp(static_cast<int>(std::floor(y * kSamples)), 0, height_ - 1); }
    int column(double x) const { return std::clamp(static_cast<int>(std::floor(x * kSamples)), 0, width_ - 1); }
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    Ink &at(int x, int y) { return samples_[place(x, y)]; }

    int width_, height_;
    std::vector<Ink> samples_;
};

/// Returns the palette index of the colour closest to a given one: inks exactly, all others by shades.
std::uint8_t nearest(Rgb colour) {
    for (std::size_t k = 0; k < kInks; ++k) {
        if (rgbOf(static_cast<Ink>(k)) == colour) {
            return static_cast<std::uint8_t>(k);
        }
    }
    int number = 0;
    for (const std::uint8_t part : colour) {
        number = number * kShades + (part * (kShades - 1) + 127) / 255;
    }
    return static_cast<std::uint8_t>(static_cast<int>(kInks) + number);
}

} // namespace

std::vector<std::uint8_t> filmPalette() {
    std::vector<std::uint8_t> palette;
    for (std::size_t k = 0; k < kInks; ++k) {
        const Rgb colour = rgbOf(static_cast<Ink>(k));
        palette.insert(palette.end(), colour.begin(), colour.end());
    }
    const auto shade = [](int level) { return static_cast<std::uint8_t>(level * 255 / (kShades - 1)); };
    for (int number = 0; number < kShades * kShades * kShades; ++number) {
        palette.push_back(shade(number / (kShades * kShades)));
        palette.push_back(shade(number / kShades % kShades));
        palette.push_back(shade(number % kShades));
    }
    palette.resize(std::size_t{3} * 256, 0);
    return palette;
}

FilmPicture paintScene(const FilmScene &scene) {
    SamplePicture picture(scene.width, scene.height);
    const Vec2 corner{static_cast<double>(scene.width), static_cast<double>(scene.height)};
    for (const FilmElement &element : scene.elements) {
        picture.polygon(element, Ink::Face);
    }
    for (const FilmLine &line : scene.lines) {
        picture.line(line);
    }
    for (const FilmCircle &circle : scene.circles) {
        picture.circle(circle);
    }
    if (scene.paperFrom) {
        picture.rectangle({0.0, *scene.paperFrom}, corner, Ink::Paper);
    }
    for (const FilmLine &line : textStrokes(scene)) {
        picture.line(line);
    }
    picture.rectangle({0.0, scene.height - 4.0}, {scene.progress * scene.width, corner.y}, Ink::Front);
    FilmPicture result{scene.width, scene.height, {}};
    result.pixels.reserve(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height));
    for (int y = 0; y < scene.height; ++y) {
        for (int x = 0; x < scene.width; ++x) {
            result.pixels.push_back(nearest(picture.pixel(x, y)));
        }
    }
    return result;
}

} // namespace forefront
