import { render } from "preact";
import { connect } from "./server";
import { ParticipantPage } from "./participant_page";

connect();
render(<ParticipantPage />, document.getElementById("study")!);
