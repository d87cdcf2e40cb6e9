// The program of pages that repeat their run: the explorer and the simulator.
import "../main";
import { readData } from "../data";
import { Panel } from "./panel";

const place = document.getElementById("again"),
  data = place && readData();
if (place && data) new Panel(place, data.runs[0]);
