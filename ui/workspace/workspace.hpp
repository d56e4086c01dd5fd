#pragma once

#include "core/drawing/shapes/references.hpp"
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
};

/// The open document with its view and selection, and everything computed from it.
struct Workspace : WidgetContext {
    DocumentStore document;
    MessageLog log{document};
    RunControl run;
    DocumentExaminer examiner;
    std::shared_ptr<const DocumentPreview> preview; ///< of this frame, never null
    MeshJudge judge;
    std::shared_ptr<const Judgement> judgement; ///< of this frame, never null
    PictureStore pictures{[this] { platform.wake(); }};
    Probe probe;
    View view;
    Selection selection;
    Snapping snapping;
    EnteredFormulas entered;
    FieldFault fieldFault;

    explicit Workspace(Platform &owner)
        : WidgetContext(owner), run(document, log, [&owner] { owner.wake(); }), examiner([&owner] { owner.wake(); }),
          preview(examiner.latest()), judge([&owner] { owner.wake(); }), judgement(judge.latest()) {
        // Nothing that is gone, hidden or locked stays selected, however the document changes.
        document.observe([this](const Document &next) { selection.prune(next); });
    }
};

} // namespace forefront
