#include "app/language.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <array>

#include "app/settings.h"

// The macro declares a function of the global namespace.
static void register_translations() {
  Q_INIT_RESOURCE(gnathion_translations);
}

namespace gnathion {
namespace {

constexpr std::array<const char*, 3> language_names{"system", "en", "de"};
constexpr const char* key = "language";
constexpr const char* translator_name = "translator";

bool is_german(Language language) {
  if (language != Language::system) return language == Language::german;
  const QStringList wanted = QLocale::system().uiLanguages();
  return !wanted.isEmpty() && QLocale(wanted.front()).language() == QLocale::German;
}

void install(const QString& name, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(translator_name);
  if (translator->load(name, folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

Language chosen_language() {
  const QString name = window_settings().value(key).toString();
  for (std::size_t i = 0; i < language_names.size(); ++i) {
    if (name == language_names[i]) return static_cast<Language>(i);
  }
  return Language::system;
}

void choose_language(Language language) {
  window_settings().setValue(key, language_names.at(static_cast<std::size_t>(language)));
}

void start_language() {
  register_translations();
  qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(translator_name));
  if (!is_german(chosen_language())) return;
  // Qt's own words: the buttons and file dialogs. Where they are not installed, those are English.
  install("qtbase_de", QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install("gnathion_de", ":/translations");
}

void connect_language_actions(QAction& system, QAction& english, QAction& german,
                              const std::function<void(const QString&)>& say) {
  auto* group = new QActionGroup(&system);
  const std::array<QAction*, 3> actions{&system, &english, &german};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    group->addAction(actions[i]);
    QObject::connect(actions[i], &QAction::triggered, &system, [i, say] {
      choose_language(static_cast<Language>(i));
      say(QCoreApplication::translate("language",
                                      "The window speaks the chosen language when Gnathion is "
                                      "started again."));
    });
  }
  actions.at(static_cast<std::size_t>(chosen_language()))->setChecked(true);
}

}  // namespace gnathion
