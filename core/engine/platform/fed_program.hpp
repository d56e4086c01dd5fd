#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace forefront {

/// Another program that runs and reads bytes on its standard input, such as an encoder. It is stopped when this ends.
class FedProgram {
  public:
    /// Starts a program, found as the shell finds it. `call`: its name and its words. Returns null on failure, with the
    /// reason as an errno in `failure`: ENOENT if there is no such program, ENOSYS if the system cannot do this.
    static std::unique_ptr<FedProgram> start(std::span<const std::string> call, int &failure);
    FedProgram(const FedProgram &) = delete;
    FedProgram &operator=(const FedProgram &) = delete;
    ~FedProgram();

    /// Waits until the program has taken all bytes. Returns false if it has ended.
    bool send(std::span<const std::uint8_t> bytes);
    /// Ends its input and waits for its end. Returns its exit status, -1 if it was ended by a signal.
    int finish();
    /// Returns the first line that it has written to its standard error.
    std::string firstWords() const;

  private:
    FedProgram();
    struct Process;
    std::unique_ptr<Process> process_;
};

} // namespace forefront
