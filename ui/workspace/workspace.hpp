#pragma once

#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"
#include "ui/background/background_list.hpp"
#include "ui/widgets/widget_context.hpp"
#include "ui/workspace/document/document_examiner.hpp"
#include "ui/workspace/document/document_store.hpp"
#include "ui/workspace/document/picture_store.hpp"
#include "ui/workspace/mesh/mesh_judge.hpp"
#include "ui/workspace/mesh/probe.hpp"
#include "ui/workspace/messages/message_log.hpp"
#include "ui/workspace/run/run_control.hpp"
#include "ui/workspace/view/snapping.hpp"
#include "ui/workspace/view/view.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

/// Formulas typed into fields, kept until a command sets their numbers.
struct EnteredFormulas {
    std::map<NumberAddress, std::string> texts;
    int frame = -1; ///< in which they were entered
};

/// The fault of the text last typed into a field, or a remark on it.
struct FieldFault {
    std::string field; ///< name of the widget; empty: none
    std::string text;
    std::uint64_t revision = 0; ///< of the document
    int frame = 0;              ///< in which it was typed
    bool note = false;          ///< the text is no fault, but a remark
    bool keepsText = false;     ///< the field goes on showing the refused text
    Selection selection{};      ///< at that time; fields show what is selected
    /// A dimension that holds what was typed, and the value that would let it be so: see drawFieldOffer().
    std::optional<DimensionChange> change{};
};

/// The open document with its view and selection, and everything computed from it.
struct Workspace : WidgetContext {
    BackgroundList background{[this] { platform.wake(); }}; ///< before all activities that are in it
    DocumentStore document;
    MessageLog log{document};
    RunControl run{document, log, background};
    DocumentExaminer examiner{background};
    std::shared_ptr<const DocumentPreview> preview = examiner.preview(); ///< of this frame, never null
    MeshJudge judge{background};
    std::shared_ptr<const Judgement> judgement = judge.now(); ///< of this frame, never null
    PictureStore pictures{background};
    Probe probe;
    View view;
    Selection selection;
    Snapping snapping;
    EnteredFormulas entered;
    FieldFault fieldFault;

    explicit Workspace(Platform &owner) : WidgetContext(owner) {
        // Nothing that is gone, hidden or locked stays selected, however the document changes.
        document.observe([this](const Document &next) { selection.prune(next); });
    }

    /// Makes the result of a command the document, with the formulas that were typed for it, or says why the command
    /// was refused. `label`: for undo. `merge`: as for DocumentStore::apply(). Returns true if it was applied.
    bool applyCommand(Result<Document> next, const std::string &label, const std::string &merge = {});
};

} // namespace forefront
