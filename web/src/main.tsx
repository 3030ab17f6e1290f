import { render } from "preact";
import { connect } from "./studio";
import { listenToShortcuts } from "./panels/shortcuts";
import { StudioPage } from "./panels/studio_page";

connect();
listenToShortcuts();
render(<StudioPage />, document.getElementById("studio")!);
