#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/style/colour.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
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

/// Makes the thumbnails of projects one after the other on a separate thread.
class Thumbnails {
  public:
    /// `wake` is called from that thread after each thumbnail.
    Thumbnails(std::vector<std::filesystem::path> projects, std::function<void()> wake);
    /// Makes the thumbnail of each project with `make`; for tests.
    using Make =
        std::function<std::shared_ptr<const Thumbnail>(const std::filesystem::path &, const std::stop_token &)>;
    Thumbnails(std::vector<std::filesystem::path> projects, std::function<void()> wake, Make make);
    ~Thumbnails();
    Thumbnails(const Thumbnails &) = delete;
    Thumbnails &operator=(const Thumbnails &) = delete;

    /// Returns the thumbnail of a project; null while it is being made.
    std::shared_ptr<const Thumbnail> at(std::size_t project) const;
    /// Returns true once all are made.
    bool done() const;

  private:
    void work(const std::stop_token &stop);

    const std::vector<std::filesystem::path> projects_;
    std::function<void()> wake_;
    Make make_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const Thumbnail>> made_;
    std::jthread thread_; ///< last: it uses all of the above
};

} // namespace forefront
