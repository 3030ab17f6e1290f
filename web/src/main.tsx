import { render } from "preact";
import { connect } from "./studio";

connect();
render(<main />, document.getElementById("studio")!);
