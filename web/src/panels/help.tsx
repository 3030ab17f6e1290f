import { keys } from "../keys";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { keyName } from "./key_names";
import { isHelpOpen, returnToDefaultLayout } from "./page";
import { startTour } from "./tour";

export function Help() {
  const close = () => (isHelpOpen.value = false);
  return (
    <Dialog
      title={texts.help.title}
      class="help"
      isForReading
      onClose={close}
      actions={
        <Button
          label={texts.help.tour}
          kind="accent"
          onClick={() => {
            close();
            startTour();
          }}
        />
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
                <dd>{key.does}</dd>
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
      </div>
    </Dialog>
  );
}
