#pragma once

#include "core/engine/session/session_mode.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/files/source/file_stamp.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "ui/workspace/view/view.hpp"
#include "ui/workspace/view/workspaces.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// A lesson in the list of lessons.
struct LessonEntry {
    std::string id; ///< name of its file without extension, or the path of a user's file; key of its progress
    std::filesystem::path file;
    std::shared_ptr<const Lesson> lesson;
    std::string edition; ///< differs between versions of its file and drawings
};

/// The lesson being read, its page and the answers given there.
struct OpenLesson {
    enum class Reply : std::uint8_t { None, Wrong, Right, Shown };

    LessonEntry entry;
    std::size_t page = 0;
    Reply reply = Reply::None;         ///< to the last answer
    std::optional<std::size_t> picked; ///< the last choice
    std::string typed;                 ///< answer that is a number
    std::string complaint;             ///< why the text typed cannot be an answer; empty: it can
    std::string hint;                  ///< after the last answer, if it is wrong; may be empty
    bool shown = false;                ///< Show me has led to the answer
    std::string before;                ///< how the task was done when the page was shown before; empty: it was not
    bool restored = false;             ///< the answer given before is shown, if there is one
    bool fresh = false;                ///< the page is shown anew, from its top
    int framesToReply = 0;             ///< frames in which the pane still scrolls to the reply
    std::optional<std::size_t> tried;  ///< the wrong candidate that was chosen last for a task
    bool focus = false;                ///< move the keyboard to the field for the number
    bool settled = false;              ///< the run has reached the position of the page
    int framesSettled = 0;             ///< frames drawn since, up to a few
    int framesToReveal = 0;            ///< frames in which outlined widgets still scroll into view
    std::set<std::size_t> checked{};   ///< pages whose references have been checked
    std::uint64_t revision = 0;        ///< of the document, when the page was shown
    std::uint64_t runRevision = 0;     ///< the same, as RunControl::shownRevision() counts them
    std::shared_ptr<const Document> document;
    std::shared_ptr<const SessionSnapshot> arrived; ///< the run at the position of the page; null: not yet
    std::shared_ptr<const SessionSnapshot> done;    ///< the run in which the task was done; null: not yet
    std::map<std::string, bool> layersBefore;       ///< visible layers, restored at the end
    WorkspaceKind workspaceBefore = WorkspaceKind::Draw;
    bool panelsBefore = true;
    ColourChoice coloursBefore;
    Granularity unitBefore = Granularity::Advance; ///< of the steps along the timeline

    /// Returns true if the question no longer needs an answer.
    bool isSolved() const { return reply == Reply::Right || reply == Reply::Shown; }
    const LessonPage &now() const { return entry.lesson->pages[page]; }
};

/// The user's drawing while lessons show theirs.
struct KeptDrawing {
    std::shared_ptr<const Document> document;
    std::filesystem::path path; ///< empty: it has no file
    FileStamp stamp;            ///< of the file
    std::string title;
    bool dirty = false;
};

/// The answers of the learner to a lesson.
struct LearnerAnswers {
    LessonAnswers given;
    bool saved = false;     ///< as a file of the learner
    LessonAnswers kept{};   ///< as they were when their file was read or written last
    std::string keptText{}; ///< of that file; empty: there was none
};

/// The pane of lessons: the list of lessons, or the one being read.
struct LessonRoom {
    bool visible = false;
    bool listed = false; ///< the lessons have been read
    std::vector<LessonEntry> list;
    std::optional<OpenLesson> open;
    std::optional<KeptDrawing> kept;               ///< comes back when the lesson is closed
    std::filesystem::path folder;                  ///< where answers are kept, a file for each lesson; empty: nowhere
    std::map<std::string, LearnerAnswers> answers; ///< by id of the lesson
    std::set<std::string> looked;                  ///< ids of the lessons whose kept answers have been looked for
    std::string last;                              ///< id of the lesson opened last; empty: none
    std::uint64_t drawingLoaded = 0; ///< DocumentStore::loads() of the last drawing that a lesson brought; 0: none
};

} // namespace forefront
