#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "ui/dialogs/file_dialog.hpp"

#include <atomic>
#include <future>
#include <memory>
#include <stop_token>

namespace forefront {

/// Writes a mesh on a separate thread and shows the progress. Cancel stops it and leaves no file.
class WriteDialog final : public Dialog {
  public:
    /// `write` reports its progress in `fraction`, 0 to 1, and ends early when `stop` is requested.
    using Write = std::function<Diagnostics(std::atomic<double> &fraction, std::stop_token stop)>;
    WriteDialog(std::string file, Write write, std::function<void(Shell &)> done);
    ~WriteDialog() override;

    const char *id() const override { return "writing"; }
    std::string title() const override { return "Writing"; }
    bool closesOnEscape() const override { return false; }
    bool draw(Shell &context) override;

  private:
    std::string file_;
    std::function<void(Shell &)> done_;
    std::stop_source stop_;
    std::shared_ptr<std::atomic<double>> fraction_ = std::make_shared<std::atomic<double>>(0.0);
    std::future<Diagnostics> result_;
};

} // namespace forefront
