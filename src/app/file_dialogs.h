#pragma once

#include <QString>

class QFileDialog;
class QWidget;

namespace gnathion {

// The window's file dialogs. They are Qt's own everywhere, which follows the theme and the language
// of the program, and are deleted once they are answered. The caller connects and opens them.

QFileDialog* new_file_dialog(QWidget* parent, const char* name, const QString& title);
/// For a file or folder that is not there yet: nothing is ever overwritten.
QFileDialog* new_target_dialog(QWidget* parent, const char* name, const QString& title);
/// For a new folder, in the user's home unless he chooses another place. suggested: its name.
QFileDialog* new_folder_dialog(QWidget* parent, const char* name, const QString& title,
                               const QString& suggested);

}  // namespace gnathion
