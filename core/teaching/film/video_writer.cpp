#include "core/teaching/film/video_writer.hpp"

#include "core/engine/base/number_text.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#if !defined(_WIN32)
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
extern char **environ;
#endif

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

#if defined(_WIN32)

struct VideoWriter::Encoder {};

Result<VideoWriter> VideoWriter::open(const std::filesystem::path &, int, int, double) {
    return error("no-encoder", "videos cannot be written on this system", "write a GIF");
}
bool VideoWriter::add(const FilmPicture &) {
    return false;
}
Status VideoWriter::finish() {
    return missingEncoder();
}

#else

/// The running encoder, with the writing end of its standard input.
struct VideoWriter::Encoder {
    std::filesystem::path file, part; ///< to be written; the encoder's own
    pid_t process = -1;
    int input = -1;
    std::FILE *words = nullptr; ///< what it says, for the message of a fault
    std::vector<std::uint8_t> palette = filmPalette();
    std::vector<std::uint8_t> frame;

    Encoder() = default;
    Encoder(const Encoder &) = delete;
    Encoder &operator=(const Encoder &) = delete;
    ~Encoder() {
        closeInput();
        if (process > 0) {
            ::kill(process, SIGKILL);
            wait();
        }
        if (words != nullptr) {
            std::fclose(words);
        }
        std::error_code gone;
        std::filesystem::remove(part, gone);
    }
    void closeInput() {
        if (const int end = std::exchange(input, -1); end >= 0) {
            ::close(end);
        }
    }
    /// Returns the exit status of the process, -1 if it was ended by a signal.
    int wait() {
        int status = 0;
        while (::waitpid(std::exchange(process, -1), &status, 0) < 0 && errno == EINTR) {
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    bool start(const std::vector<std::string> &call, int &failure) {
        // A socket rather than a pipe: sending to an encoder that has ended then fails without a signal.
        std::array<int, 2> ends{-1, -1};
        words = std::tmpfile();
        if (words == nullptr || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
            failure = errno;
            return false;
        }
        input = ends[1];
        std::vector<char *> arguments;
        for (const std::string &word : call) {
            arguments.push_back(const_cast<char *>(word.c_str())); // NOLINT(cppcoreguidelines-pro-type-const-cast)
        }
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t files;
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
        ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_adddup2(&files, ::fileno(words), STDERR_FILENO);
        failure = ::posix_spawnp(&process, "ffmpeg", &files, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&files);
        ::close(ends[0]);
        if (failure != 0) {
            process = -1;
        }
        return failure == 0;
    }
    bool send(const std::vector<std::uint8_t> &bytes) const {
        for (std::size_t sent = 0; sent < bytes.size();) {
            const ssize_t count = ::send(input, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
            if (count < 0 && errno == EINTR) {
                continue;
            }
            if (count <= 0) {
                return false;
            }
            sent += static_cast<std::size_t>(count);
        }
        return true;
    }
    /// Returns the first line that the encoder has said.
    std::string firstWords() const {
        std::array<char, 400> line{};
        std::rewind(words);
        std::string text = std::fgets(line.data(), static_cast<int>(line.size()), words) != nullptr ? line.data() : "";
        while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) {
            text.pop_back();
        }
        return text;
    }
};

Result<VideoWriter> VideoWriter::open(const std::filesystem::path &file, int width, int height, double speed) {
    auto encoder = std::make_unique<Encoder>();
    encoder->file = file;
    encoder->part = file;
    encoder->part += ".part";
    int failure = 0;
    if (!encoder->start(encoderCall(file, encoder->part, width, height, speed), failure)) {
        return failure == ENOENT
                   ? missingEncoder()
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
    return encoder_->send(encoder_->frame);
}

Status VideoWriter::finish() {
    encoder_->closeInput();
    std::error_code failure;
    if (encoder_->wait() == 0) {
        std::filesystem::rename(encoder_->part, encoder_->file, failure);
        return failure ? error("cannot-write", "cannot write " + encoder_->file.string() + ": " + failure.message())
                       : Status();
    }
    const std::string words = encoder_->firstWords();
    return error("cannot-write",
                 "ffmpeg could not write " + encoder_->file.string() + (words.empty() ? std::string() : ": " + words));
}

#endif

VideoWriter::VideoWriter(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
VideoWriter::VideoWriter(VideoWriter &&) noexcept = default;
VideoWriter &VideoWriter::operator=(VideoWriter &&) noexcept = default;
VideoWriter::~VideoWriter() = default;

} // namespace forefront
