import { choicePreference } from "./ui/preference";

/** The languages of the page, by their tags (BCP 47), each with its own name. */
export const LANGUAGES = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof LANGUAGES;
const tags = Object.keys(LANGUAGES) as Language[];

/** The chosen language; "browser": the first of the browser's languages that the page has, or English. */
export const languageChoice = choicePreference("language", "browser", ["browser", ...tags]);

/** The language of the page until it is loaded again. The page of a study names its own: it is the same for all. */
export const language: Language = ofDocument() ?? (languageChoice.value === "browser" ? ofBrowser() : languageChoice.value);
document.documentElement.lang = language;

function ofDocument(): Language | undefined {
  return tags.find((tag) => tag === document.documentElement.dataset.language);
}

function ofBrowser(): Language {
  for (const wanted of navigator.languages) {
    const found = tags.find((tag) => tag === wanted.toLowerCase().split("-")[0]);
    if (found !== undefined) return found;
  }
  return "en";
}
