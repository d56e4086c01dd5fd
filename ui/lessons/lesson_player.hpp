#pragma once

#include "core/teaching/lesson/lesson.hpp"
#include "ui/workspace/view/lesson_room.hpp"

#include <cstddef>

namespace forefront {

struct Shell;

// The lesson that is read: the page shown, and the answers.

/// Opens a lesson at the page where it was left, after asking about unsaved changes to a drawing of the user. The
/// drawing of a lesson is replaced without asking, unless it was saved as a file. Answers to an earlier version of the
/// lesson are forgotten, after asking about those that are not saved. The entry takes its place in the list.
void openLesson(Shell &context, const LessonEntry &entry);
/// Returns to the list of lessons. Layers, panels, tab and colours are as before the lesson; the drawing stays.
void closeLesson(Shell &context);
/// Returns to the list of lessons after the last page. The lesson begins at its first page again.
void finishLesson(Shell &context);
/// Shows a page of the open lesson: its document, position, layers and camera.
void goToPage(Shell &context, std::size_t page);

/// Returns true while the drawing of the open lesson is in a tab that is not shown.
bool lessonIsElsewhere(const Shell &context);

/// Returns true if the run shown is of the drawing and with the options that the page has, which its question is about.
bool showsOwnRun(const Shell &context);
/// Shows the page anew, with its own drawing and options.
void bringBackDrawing(Shell &context);

/// Returns the state of the run as it is now, which tasks are about.
LessonState lessonState(const Shell &context);
/// Returns the state of the run at the position of the page, which its text is about, wherever the run has moved since.
LessonState pageState(const Shell &context);
/// Returns the state that the question of the page is about: that of the page's position, wherever the run has moved
/// since. For a task, that in which it was done, and until then that of now.
LessonState questionState(const Shell &context);
/// Answers the question of the page by a choice.
void answerChoice(Shell &context, std::size_t choice);
/// Answers the question of the page by the number typed, with a point or a comma.
void answerNumber(Shell &context);
/// Moves the run to where the answer can be seen, and records that it was shown.
void showAnswer(Shell &context);
/// Notes the state that the page is about, and checks whether a task is done. Called once per frame.
void followLesson(Shell &context);
/// Lets outlined widgets scroll into view in the first frames of a page. Called once per frame, open lesson or not.
void revealHighlights(Shell &context);

} // namespace forefront
