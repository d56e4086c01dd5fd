#include "core/teaching/film/video_writer.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/platform/fed_program.hpp"

#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the words of the call of ffmpeg that reads raw frames from its standard input.
std::vector<std::string> encoderCall(const std::filesystem::path &file, const std::filesystem::path &output, int width,
                                     int height, double speed) {
    std::vector<std::string> words = {"ffmpeg",
                                      "-nostdin",
                                      "-y",
                                      "-loglevel",
                                      "error",
                                      "-f",
                                      "rawvideo",
                                      "-pixel_format",
                                      "rgb24",
                                      "-video_size",
                                      std::to_string(width) + 'x' + std::to_string(height),
                                      "-framerate",
                                      numberText(speed, 6),
                                      "-i",
                                      "pipe:0",
                                      "-vf",
                                      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", // the codecs want even sides
                                      "-pix_fmt",
                                      "yuv420p"};
    const std::vector<std::string> codec =
        file.extension() == ".webm"
            ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-f", "webm"}
            : std::vector<std::string>{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
    words.insert(words.end(), codec.begin(), codec.end());
    words.push_back("file:" + output.string());
    return words;
}

Diagnostics missingEncoder() {
    return error("no-encoder", "videos are written by the program ffmpeg, which is not installed",
                 "install the package ffmpeg, or write a GIF");
}

} // namespace

bool isVideo(const std::filesystem::path &file) {
    return file.extension() == ".mp4" || file.extension() == ".webm";
}

/// The running encoder.
struct VideoWriter::Encoder {
    std::filesystem::path file, part; ///< to be written; the encoder's own
    std::unique_ptr<FedProgram> program;
    std::vector<std::uint8_t> palette = filmPalette();
    std::vector<std::uint8_t> frame;

    Encoder() = default;
    Encoder(const Encoder &) = delete;
    Encoder &operator=(const Encoder &) = delete;
    ~Encoder() {
        program.reset(); // which may still write its file
        std::error_code gone;
        std::filesystem::remove(part, gone);
    }
};

Result<VideoWriter> VideoWriter::open(const std::filesystem::path &file, int width, int height, double speed) {
    auto encoder = std::make_unique<Encoder>();
    encoder->file = file;
    encoder->part = file;
    encoder->part += ".part";
    int failure = 0;
    encoder->program = FedProgram::start(encoderCall(file, encoder->part, width, height, speed), failure);
    if (!encoder->program) {
        return failure == ENOENT ? missingEncoder()
               : failure == ENOSYS
                   ? error("no-encoder", "videos cannot be written on this system", "write a GIF")
                   : error("cannot-write", "cannot start ffmpeg: " + std::generic_category().message(failure));
    }
    return VideoWriter(std::move(encoder));
}

bool VideoWriter::add(const FilmPicture &picture) {
    encoder_->frame.clear();
    encoder_->frame.reserve(3 * picture.pixels.size());
    for (const std::uint8_t pixel : picture.pixels) {
        const std::uint8_t *const colour = encoder_->palette.data() + 3 * static_cast<std::size_t>(pixel);
        encoder_->frame.insert(encoder_->frame.end(), colour, colour + 3);
    }
    return encoder_->program->send(encoder_->frame);
}

Status VideoWriter::finish() {
    std::error_code failure;
    if (encoder_->program->finish() == 0) {
        std::filesystem::rename(encoder_->part, encoder_->file, failure);
        return failure ? error("cannot-write", "cannot write " + encoder_->file.string() + ": " + failure.message())
                       : Status();
    }
    const std::string words = encoder_->program->firstWords();
    return error("cannot-write",
                 "ffmpeg could not write " + encoder_->file.string() + (words.empty() ? std::string() : ": " + words));
}

VideoWriter::VideoWriter(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
VideoWriter::VideoWriter(VideoWriter &&) noexcept = default;
VideoWriter &VideoWriter::operator=(VideoWriter &&) noexcept = default;
VideoWriter::~VideoWriter() = default;

} // namespace forefront
