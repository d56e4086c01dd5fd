#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/session/snapshot.hpp"
#include "ui/background/latest.hpp"
#include "ui/dialogs/export_rows.hpp"
#include "ui/dialogs/file_dialog.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

/// A mesh that is written to a file.
struct MeshExport {
    std::shared_ptr<const MeshSnapshot> mesh;
    std::filesystem::path file;
    std::string format; ///< id
    ExportChoice choice;
};

/// Writes a mesh on a separate thread and shows the progress. Cancel stops it and leaves no file.
class WriteDialog final : public Dialog {
  public:
    /// Writes the file, reports its progress and ends early when a stop is requested.
    using Write = std::function<Diagnostics(const Progress &progress)>;
    WriteDialog(BackgroundList &list, std::string file, Write write, std::function<void(Shell &)> done);

    const char *id() const override { return "writing"; }
    std::string title() const override { return "Writing"; }
    bool closesOnEscape() const override { return false; }
    bool draw(Shell &context) override;

  private:
    struct Written {
        double fraction = 0.0;
        std::optional<Diagnostics> result{}; ///< not set: not finished
    };

    static Written answer(const LatestTurn<Write, Written> &turn);

    std::string file_;
    std::function<void(Shell &)> done_;
    bool cancelled_ = false;
    Latest<Write, Written> worker_;
};

} // namespace forefront
