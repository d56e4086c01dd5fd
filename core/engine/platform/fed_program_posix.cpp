#ifndef _WIN32

#include "core/engine/platform/fed_program.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

extern char **environ;

namespace forefront {

/// The running program, with the writing end of its standard input.
struct FedProgram::Process {
    pid_t number = -1;
    int input = -1;
    std::FILE *words = nullptr; ///< what it writes to its standard error

    Process() = default;
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;
    ~Process() {
        closeInput();
        if (number > 0) {
            ::kill(number, SIGKILL);
            wait();
        }
        if (words != nullptr) {
            std::fclose(words);
        }
    }
    void closeInput() {
        if (const int end = std::exchange(input, -1); end >= 0) {
            ::close(end);
        }
    }
    int wait() {
        int status = 0;
        while (::waitpid(number, &status, 0) < 0 && errno == EINTR) {
        }
        number = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Starts the program with a file to read. Returns an errno, 0 on success.
    int spawn(std::span<const std::string> call, int source) {
        std::vector<char *> arguments;
        for (const std::string &word : call) {
            arguments.push_back(const_cast<char *>(word.c_str())); // NOLINT(cppcoreguidelines-pro-type-const-cast)
        }
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t files;
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawn_file_actions_adddup2(&files, source, STDIN_FILENO);
        ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_adddup2(&files, ::fileno(words), STDERR_FILENO);
        const int failure = ::posix_spawnp(&number, arguments.front(), &files, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&files);
        if (failure != 0) {
            number = -1;
        }
        return failure;
    }
};

FedProgram::FedProgram() : process_(std::make_unique<Process>()) {}
FedProgram::~FedProgram() = default;

std::unique_ptr<FedProgram> FedProgram::start(std::span<const std::string> call, int &failure) {
    std::unique_ptr<FedProgram> program(new FedProgram());
    Process &process = *program->process_;
    // A socket rather than a pipe: sending to a program that has ended then fails without a signal.
    std::array<int, 2> ends{-1, -1};
    process.words = std::tmpfile();
    if (process.words == nullptr || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        failure = errno;
        return nullptr;
    }
    process.input = ends[1];
    failure = process.spawn(call, ends[0]);
    ::close(ends[0]);
    return failure == 0 ? std::move(program) : nullptr;
}

bool FedProgram::send(std::span<const std::uint8_t> bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count = ::send(process_->input, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
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

int FedProgram::finish() {
    process_->closeInput();
    return process_->wait();
}

std::string FedProgram::firstWords() const {
    std::array<char, 400> line{};
    std::rewind(process_->words);
    std::string text =
        std::fgets(line.data(), static_cast<int>(line.size()), process_->words) != nullptr ? line.data() : "";
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) {
        text.pop_back();
    }
    return text;
}

} // namespace forefront

#endif
