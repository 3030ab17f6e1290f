function [demo, steps, containers, presses, notes] = understand(aux)
% Reads or watches the demonstration of a brain, and prints what it shows: the steps of the task, see inferTask, and the presses
% of switches and uses of tools, see inferDevices.
%   notes  what was understood, one line each, a cell
  if exist(fullfile(aux.demonstration, '0.txt'), 'file')
    demo = readDemonstration(aux.demonstration);
  else  % a recording without texts: from its pictures alone
    demo = watchDemonstration(aux.demonstration);
  end
  needs = needsOf(aux, demo);
  [steps, containers, appearances] = inferTask(demo, aux.attention, needs);
  [keyframes, goal] = explain(demo, appearances, containers);
  presses = inferDevices(demo, steps, appearances, needs);
  notes = strcat({'understood: '}, strtrim(printPage(keyframes, goal, demo.unclear)));
  printSteps(steps);
  printPresses(presses, steps);
end
