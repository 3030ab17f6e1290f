function paths = cuttingPaths(scissors, string, legs)
% Returns ways to take the scissors, cut a leg of the string, and put them back, the best first. The left finger goes left
% or right of the grip, nearer to the blades or to the rings.
  grasp = 0.45;      % height of the tool above the middle of the scissors
  away = 3.4;        % distance of the middle of the scissors from the string
  blades = 2.2;      % and when it is between their blades
  turns = [5, 3, 2.4; 3.4, 3.4, 4.2];  % beside the string and before it, where the scissors are turned towards it
  seen = insidePlace(string, scissors.middle);
  turns(1, :) = turns(1, :) * (1 - 2 * (seen(1) < 0));
  paths = {};
  for lifted = [2, 1]  % height of the middle of the scissors before and after
    for offset = [0, 0.5, -0.5]
      for across = {'line', 'joints'}
        for side = [1, -1]
          for leg = legs'
            height = leg(2) + grasp;
            over = poseAt(pointAt(scissors, 0, offset, lifted + grasp), side * scissors.x);
            take = poseAt(pointAt(scissors, 0, offset, 0.4 + grasp), side * scissors.x);
            put = poseAt(pointAt(scissors, 0, offset, 0.42 + grasp), side * scissors.x);
            before = poseAt(pointAt(string, leg(1), offset - away, height), side * string.x);
            there = poseAt(pointAt(string, leg(1), offset - blades, height), side * string.x);
            how = across{1};
            for turn = turns
              beside = poseAt(pointAt(string, turn(1), offset - turn(2), height), side * string.x);
              paths{end + 1} = {'joints', over; 'line', take; 'line', over; how, beside; how, before; 'line', there; ...
                                'line', before; how, beside; how, over; 'line', put; 'line', over};
            end
          end
        end
      end
    end
  end
end
