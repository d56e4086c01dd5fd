#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/background/latest.hpp"
#include "ui/style/colour.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace forefront {

/// A small picture of a meshed project, with a few hundred elements, or none if the project has faults.
struct Thumbnail {
    Box2 box;
    std::vector<Vec2> nodes;
    std::vector<std::array<std::uint32_t, 3>> elements;
    std::vector<std::array<std::uint32_t, 2>> edges;    ///< between elements
    std::vector<std::array<std::uint32_t, 2>> boundary; ///< tagged edges
    std::vector<float> fineness;                        ///< per element: 0 where ρ is finest, 1 where it is coarsest
};

/// Makes the thumbnail of the project in a file, or of a text of one.
std::shared_ptr<const Thumbnail> makeThumbnail(const std::filesystem::path &project, const std::stop_token &stop);
std::shared_ptr<const Thumbnail> makeThumbnail(const std::string &projectText, const std::stop_token &stop);

/// Makes the thumbnails of projects one after the other on a separate thread, which is left behind if it hangs in
/// reading a file.
class Thumbnails {
  public:
    /// Makes the thumbnail of a project.
    using Make =
        std::function<std::shared_ptr<const Thumbnail>(const std::filesystem::path &, const std::stop_token &)>;
    Thumbnails(BackgroundList &list, std::vector<std::filesystem::path> projects);
    /// `make`: for projects that are not in files, and for tests.
    Thumbnails(BackgroundList &list, std::vector<std::filesystem::path> projects, Make make);

    /// Fetches those made since the last call. Returns true if there are any.
    bool refresh() { return worker_.refresh(); }
    /// Returns the thumbnail of a project; null while it is being made.
    std::shared_ptr<const Thumbnail> at(std::size_t project) const { return worker_.now()[project]; }
    /// Returns true once all have been fetched.
    bool done() const;

  private:
    using Projects = std::vector<std::filesystem::path>;
    using Made = std::vector<std::shared_ptr<const Thumbnail>>;

    Latest<Projects, Made> worker_;
};

} // namespace forefront
