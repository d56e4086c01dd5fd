#pragma once

#include "core/engine/base/result.hpp"
#include "core/teaching/film/film_picture.hpp"

#include <filesystem>
#include <memory>

namespace forefront {

/// Writes frames as a video, MP4 (H.264) or WebM (VP9) by the extension of the file, through the program ffmpeg. The
/// file appears when it is whole; without finish() nothing is left.
class VideoWriter {
  public:
    /// Faults: no-encoder (ffmpeg is not installed), cannot-write. `speed`: frames per second.
    static Result<VideoWriter> open(const std::filesystem::path &file, int width, int height, double speed);
    VideoWriter(VideoWriter &&) noexcept;
    VideoWriter &operator=(VideoWriter &&) noexcept;
    ~VideoWriter();

    /// Adds a frame of the size given to open(). Returns false if the encoder has ended; finish() says why.
    bool add(const FilmPicture &picture);
    /// Waits for the encoder and puts the file in its place. Fault: cannot-write, with the words of the encoder.
    Status finish();

  private:
    struct Encoder;
    explicit VideoWriter(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

/// Returns true for the extensions of videos, .mp4 and .webm.
bool isVideo(const std::filesystem::path &file);

} // namespace forefront
