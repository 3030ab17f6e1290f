#pragma once

namespace CLI {
class App;
}

namespace smile::app {

/// Exit code of the command that ran; each Add…() stores its answer here.
using ExitAnswer = int*;

// Each function adds one command of the program, with its options, help and action.
void AddCheck(CLI::App* program, ExitAnswer answer);
void AddRun(CLI::App* program, ExitAnswer answer);
void AddStudio(CLI::App* program, ExitAnswer answer);
void AddStudy(CLI::App* program, ExitAnswer answer);
void AddReplay(CLI::App* program, ExitAnswer answer);
void AddHistory(CLI::App* program, ExitAnswer answer);
void AddDescribe(CLI::App* program, ExitAnswer answer);
void AddAnalyze(CLI::App* program, ExitAnswer answer);
void AddCheckout(CLI::App* program, ExitAnswer answer);
void AddCorrect(CLI::App* program, ExitAnswer answer);
void AddEdit(CLI::App* program, ExitAnswer answer);
void AddImport(CLI::App* program, ExitAnswer answer);
void AddExport(CLI::App* program, ExitAnswer answer);
void AddDoctor(CLI::App* program, ExitAnswer answer);
void AddRos(CLI::App* program, ExitAnswer answer);
void AddRerender(CLI::App* program, ExitAnswer answer);
void AddRender(CLI::App* program, ExitAnswer answer);
void AddLayout(CLI::App* program, ExitAnswer answer);
void AddRobots(CLI::App* program, ExitAnswer answer);
void AddImitate(CLI::App* program, ExitAnswer answer);
void AddEvaluate(CLI::App* program, ExitAnswer answer);
void AddGenerate(CLI::App* program, ExitAnswer answer);
void AddMerge(CLI::App* program, ExitAnswer answer);
void AddTabulate(CLI::App* program, ExitAnswer answer);
void AddExperiment(CLI::App* program, ExitAnswer answer);
void AddCommands(CLI::App* program, ExitAnswer answer);
void AddProtocol(CLI::App* program, ExitAnswer answer);
void AddBench(CLI::App* program, ExitAnswer answer);

}  // namespace smile::app
