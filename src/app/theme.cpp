#include "app/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QStyle>
#include <QStyleFactory>
#include <array>

#include "app/settings.h"

namespace gnathion {
namespace {

constexpr std::array<const char*, 3> theme_names{"system", "light", "dark"};
constexpr const char* key = "theme";

/// What the desktop gave the application, before the first change.
struct Desktop {
  QString style = QApplication::style()->objectName();
  QPalette palette = QApplication::palette();
};

const Desktop& desktop() {
  static const Desktop found;
  return found;
}

QPalette palette_of(const QColor& window, const QColor& base, const QColor& button,
                    const QColor& text, const QColor& dim, const QColor& highlight,
                    const QColor& link) {
  QPalette palette(text, button, button.lighter(130), button.darker(160), button.darker(120), text,
                   Qt::white, base, window);
  palette.setColor(QPalette::AlternateBase, button);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Highlight, highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, link);
  palette.setColor(QPalette::PlaceholderText, dim);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, button.darker(110));
  return palette;
}

QPalette light_palette() {
  return palette_of("#f0f2f4", "#ffffff", "#e6e9ec", "#1b1f23", "#848c94", "#1f6fb2", "#1f5f9a");
}

QPalette dark_palette() {
  return palette_of("#363b41", "#1d2023", "#464d54", "#e8eaec", "#8b939b", "#2f7fc4", "#7db8ea");
}

void apply(Theme theme) {
  const Desktop& found = desktop();
  const bool as_desktop = theme == Theme::system;
  QApplication::setStyle(QStyleFactory::create(as_desktop ? found.style : QString("Fusion")));
  QApplication::setPalette(as_desktop             ? found.palette
                           : theme == Theme::dark ? dark_palette()
                                                  : light_palette());
}

}  // namespace

Theme chosen_theme() {
  const QString name = window_settings().value(key).toString();
  for (std::size_t i = 0; i < theme_names.size(); ++i) {
    if (name == theme_names[i]) return static_cast<Theme>(i);
  }
  return Theme::system;
}

void choose_theme(Theme theme) {
  window_settings().setValue(key, theme_names.at(static_cast<std::size_t>(theme)));
  apply(theme);
}

void start_theme() {
  desktop();
  if (chosen_theme() != Theme::system) apply(chosen_theme());
}

void connect_theme_actions(QAction& system, QAction& light, QAction& dark) {
  auto* group = new QActionGroup(&system);
  const std::array<QAction*, 3> actions{&system, &light, &dark};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    group->addAction(actions[i]);
    QObject::connect(actions[i], &QAction::triggered, &system,
                     [i] { choose_theme(static_cast<Theme>(i)); });
  }
  actions.at(static_cast<std::size_t>(chosen_theme()))->setChecked(true);
}

QColor warning_colour(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? "#ffb35c" : "#a04f00";
}

}  // namespace gnathion
