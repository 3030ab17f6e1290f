import { keys } from "../keys";
import { LANGUAGES, languageChoice, type Language } from "../language";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { keyName, meaningOf } from "./key_names";
import { isHelpOpen, returnToDefaultLayout } from "./page";
import { hasTour, startTour } from "./tour";

export function Help() {
  const close = () => (isHelpOpen.value = false);
  return (
    <Dialog
      title={texts.help.title}
      class="help"
      isForReading
      onClose={close}
      actions={
        hasTour.value && (
          <Button
            label={texts.help.tour}
            kind="accent"
            onClick={() => {
              close();
              startTour();
            }}
          />
        )
      }
    >
      <div class="help-columns">
        <section>
          <h3>{texts.help.mouse}</h3>
          <dl>
            {texts.help.mouseHelp.map(([deed, effect]) => (
              <div key={deed}>
                <dt>{deed}</dt>
                <dd>{effect}</dd>
              </div>
            ))}
          </dl>
        </section>
        <section>
          <h3>{texts.help.keys}</h3>
          <dl>
            {keys.map((key) => (
              <div key={key.what}>
                <dt>
                  <kbd>{keyName(key.keys[0]!)}</kbd>
                </dt>
                <dd>{meaningOf(key.what)}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
      <p>{texts.help.everywhere}</p>
      <div class="row">
        <Button
          label={texts.help.layout}
          title={texts.help.layoutWhy}
          onClick={() => {
            close();
            returnToDefaultLayout();
          }}
        />
        <LanguageChoice />
      </div>
    </Dialog>
  );
}

/** Texts are read once, when the page is loaded: another language loads it again. */
function LanguageChoice() {
  const { language: words } = texts;
  const choose = (choice: string) => {
    languageChoice.value = choice as "browser" | Language;
    location.reload();
  };
  return (
    <label class="language" title={words.why}>
      <span>{words.label}</span>
      <select value={languageChoice.value} onChange={(event) => choose(event.currentTarget.value)}>
        <option value="browser">{words.ofBrowser}</option>
        {Object.entries(LANGUAGES).map(([tag, name]) => (
          <option key={tag} value={tag} lang={tag}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
