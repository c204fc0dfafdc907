(SOURCE set-up sheet of g31: tools as they truly are, tool probes, fixtures)
(CONTROL fanuc-16i)
(CONTROL fanuc-30i)
(CONTROL haas)
(START Z = 200)

(CASE a tool probe signals where the true tool touches it, not the believed one)
(SHEET [tools.5])
(SHEET length = 99.0)
(SHEET radius = 8.5)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
%
O1
T5 M6
G31 Z90. F100.
#100=#5063
G0 Z120.
X-40.
Z97.
G31 X-10. F100.
#101=#5061
M30
%
(EXPECT #100 = 100)
(EXPECT #101 = -18)
(EXPECT NO WARNING PRB311)

(CASE a tool of which the sheet says nothing is what the control believes)
(SHEET [tools.5])
(SHEET length = 99.0)
(SHEET radius = 8.5)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
%
O1
T5 M6
G31 Z90. F100.
#100=#5063
M30
%
(EXPECT #100 = 99)

(CASE a tool that goes into a tool probe at rapid breaks it)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
%
O1
T5 M6
G0 Z90.
M30
%
(EXPECT COLLISION AT 10)

(CASE a tool cuts parts and must not meet clamps)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[part]])
(SHEET shape = "block")
(SHEET [[part]])
(SHEET name = "clamp")
(SHEET shape = "block")
(SHEET at = [80.0, 0.0, 0.0])
(SHEET length = 20.0)
(SHEET fixture = true)
%
O1
T5 M6
G1 Z95. F500.
X50.
X70.
M30
%
(EXPECT MOVE 1 Z95)
(EXPECT MOVE 2 X50)
(EXPECT COLLISION AT 18)

(CASE the holder must not meet the part that its tool cuts)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool.body]])
(SHEET length = 70.0)
(SHEET diameter = 50.0)
(SHEET [[part]])
(SHEET shape = "block")
%
O1
T5 M6
G1 Z75. F500.
Z65.
M30
%
(EXPECT MOVE 1 Z75)
(EXPECT COLLISION AT 14)

(CASE the touch probe meets the tool probe as an obstacle)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
%
O1
G31 Z100. F100.
M30
%
(EXPECT COLLISION AT 7)

(CASE a standing mill touches with the tooth that faces the plate, a turning one with the longest)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 20.0)
(SHEET teeth = [{ angle_deg = 0.0, radius = 9.5 }, { angle_deg = 180.0 }])
(SHEET [[tool_probe]])
(SHEET size = 20.0)
%
O1
T5 M6
G0 Z120.
X-40.
Z97.
G31 X-10. F100.
#100=#5061
G0 X-40.
M19 R180.
G31 X-10. F100.
#101=#5061
M30
%
(EXPECT #100 = -19.5)
(EXPECT #101 = -20)

(CASE a laser is broken from both sides)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET shape = "laser")
(SHEET size = [200.0, 1.0])
%
O1
T5 M6
G0 Y-40.
Z97.
G31 Y0 F100.
#100=#5062
G1 Y40. F1000.
G31 Y0 F100.
#101=#5062
M30
%
(EXPECT #100 = -8.5)
(EXPECT #101 = 8.5)

(CASE a chip on the tool probe hands on what touches it)
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
(SHEET [[part]])
(SHEET name = "chip")
(SHEET shape = "block")
(SHEET at = [4.0, 0.0, 0.75])
(SHEET length = 2.0)
(SHEET width = 3.0)
(SHEET height = 0.75)
%
O1
T5 M6
G31 Z90. F100.
#100=#5063
M30
%
(EXPECT #100 = 100.75)

(CASE a tool probe on the bed stays where it is while the table turns)
(SHEET [machine])
(SHEET table_side = "C")
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
(SHEET at = [60.0, 0.0, 0.0])
(SHEET side = "bed")
%
O1
T5 M6
G0 C90.
X60. Y0
G31 Z90. F100.
#100=#5063
M30
%
(EXPECT #100 = 100)

(CASE a tool probe on the table turns with it)
(SHEET [machine])
(SHEET table_side = "C")
(SHEET [[tool]])
(SHEET number = 5)
(SHEET length = 100.0)
(SHEET diameter = 16.0)
(SHEET [[tool_probe]])
(SHEET size = 20.0)
(SHEET at = [60.0, 0.0, 0.0])
(SHEET side = "table")
%
O1
T5 M6
G0 C90.
X0 Y-60.
G31 Z90. F100.
#100=#5063
M30
%
(EXPECT #100 = 100)
