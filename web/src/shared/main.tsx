import { render } from "preact";
import { load } from "./player";
import { SharedPage } from "./shared_page";

void load();
render(<SharedPage />, document.getElementById("shared")!);
