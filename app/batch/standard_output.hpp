#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

/// Standard output as a sink that records why writing failed, which stdio does not report.
class StandardOutput final : public ByteSink {
  public:
    StandardOutput();
    bool write(std::string_view bytes) override;
    /// Returns the error number of the first failure; 0 if there is none.
    int failure() const { return failure_; }
    /// Returns the fault cannot-write with the reason, if there is one.
    Status status() const;

  private:
    int failure_ = 0;
};

} // namespace forefront
