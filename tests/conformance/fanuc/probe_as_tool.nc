(SOURCE set-up sheet of g31: the probe is a tool, is switched on and off, shows itself on inputs)
(CONTROL fanuc-16i)
(CONTROL fanuc-30i)
(CONTROL haas)
(START Z = 200)

(CASE the spindle holds the probe until a program changes the tool)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 Z100. F100.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT NO WARNING PRB311)

(CASE another tool gives no signal, and each measuring move with it is reported)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5 M6
G31 Z100. F100.
#100=#5063
G00 Z200.
T1
M6
G31 Z100. F100.
#101=#5063
M30
%
(EXPECT #100 = 100)
(EXPECT #101 = 123)
(EXPECT WARNING PRB311 AT 8)

(CASE T alone selects, M6 changes; M6 without a T changes nothing)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M6
T5
G31 Z100. F100.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT NO WARNING PRB311)

(CASE an empty spindle measures nothing)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T0 M6
G31 Z150. F100.
M30
%
(EXPECT WARNING PRB311 AT 8)

(CASE another tool goes through the part at feed and at rapid)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [tools.5])
(SHEET length = 100.0)
(SHEET radius = 8.0)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M6 T5
G43 H5 Z100.
G01 Z-10. F200.
X20.
G02 X0 Y20. R20.
G00 Z50.
M30
%
(EXPECT MOVES 5)
(EXPECT MOVE 2 G1 Z90)
(EXPECT MOVE 5 G0 Y20 Z150)

(CASE without a number the probe is there, whatever tool is called)
(SHEET [probe])
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5 M6
M3 S500
G31 Z100. F100.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT NO WARNING PRB311)
(EXPECT NO WARNING PRB313)

(CASE a probe with a code that switches it on is off at the start)
(SHEET [probe])
(SHEET on = "M80")
(SHEET off = "M81")
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 Z150. F100.
M80
G31 Z100. F100.
#100=#5063
G00 Z150.
M81
G31 Z140. F100.
M30
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB312 AT 8)
(EXPECT WARNING PRB312 AT 14)

(CASE a measuring move with a turning spindle is reported; M5 and M19 stop it)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
S500 M4
G31 Z100. F100.
#100=#5063
G00 Z200.
M5
G31 Z100. F100.
#101=#5063
G00 Z200.
M3
M19
G31 Z100. F100.
#102=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT #101 = 123)
(EXPECT #102 = 123)
(EXPECT WARNING PRB313 AT 8)

(CASE inputs show whether the probe is ready and touches)
(SHEET [probe])
(SHEET tool = 1)
(SHEET on = "M80")
(SHEET ready_input = 1004)
(SHEET signal_input = 1005)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
#100=#1004
M80
#101=#1004
#102=#1005
G31 Z100. F100.
#103=#1005
#104=#1032
#105=#5063
G00 Z200.
#106=#1005
T2 M6
#107=#1004
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 1)
(EXPECT #102 = 0)
(EXPECT #103 = 1)
(EXPECT #104 = 48)
(EXPECT #106 = 0)
(EXPECT #107 = 0)

(CASE a probe that is off in a turning spindle: both are said)
(SHEET [probe])
(SHEET on = "M80")
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M3 S100
G31 Z150. F100.
M30
%
(EXPECT WARNING PRB312 AT 8)
(EXPECT WARNING PRB313 AT 8)

(CASE S turns nothing by itself)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
S3000
G31 Z100. F100.
M30
%
(EXPECT NO WARNING PRB313)

(CASE one code switches the probe on and off turn by turn)
(SHEET [probe])
(SHEET on = "M80")
(SHEET off = "M80")
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M80
G31 Z100. F100.
#100=#5063
G00 Z200.
M80
G31 Z150. F100.
M30
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB312 AT 13)

(CASE a probe that can only be switched off is on at the start)
(SHEET [probe])
(SHEET off = "M81")
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 Z100. F100.
#100=#5063
G00 Z200.
M081
G31 Z150. F100.
M30
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB312 AT 11)

(CASE a T that calls a macro: the macro brings the tool)
(PARAMETER 6001.5 = 1)
(CONTROL fanuc-16i fanuc-30i)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5
G31 Z150. F100.
T1
G31 Z100. F100.
#100=#5063
M30
O9000
#26=#149
T#26 M6
M99
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB311 AT 10)

(CASE an M6 that calls a macro: T is its argument)
(PARAMETER 6080 = 6)
(CONTROL fanuc-16i fanuc-30i)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5 M6
G31 Z150. F100.
T1 M6
G31 Z100. F100.
#100=#5063
M30
O9020
T#20 M6
M99
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB311 AT 10)

(CASE a torque limit skip listens to no probe)
(CONTROL fanuc-30i)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5 M6
G31 P98 Z100. F100.
M30
%
(EXPECT NO WARNING PRB311)
(EXPECT MOVE 1 G31 Z100)

(CASE what the probe sets goes over what was written)
(SET #1004 = 1)
(SHEET [probe])
(SHEET on = "M80")
(SHEET ready_input = 1004)
%
O1
#100=#1004
#101=#1032
M80
#102=#1004
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 0)
(EXPECT #102 = 1)

(CASE a tool may be longer than the way down, or shorter than nothing)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [tools.5])
(SHEET length = -50.0)
(SHEET [tools.6])
(SHEET length = 900.0)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
T5 M6
G00 Z0
T6 M6
G31 Z-10. F100.
M30
%
(EXPECT MOVE 2 G31 Z-10)
(EXPECT WARNING PRB311 AT 14)

(CASE a spindle that has turned and stopped stands anywhere: told where the ball runs out, until M19)
(SHEET [probe])
(SHEET tool = 1)
(SHEET eccentricity = [0.05, 0.0])
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 Z190. F1000.
M3 S500
M5
G31 Z180. F1000.
M19
G31 Z170. F1000.
#100=0
IF[#5063GT0]GOTO10
N10 M30
%
(EXPECT NO WARNING PRB313)
(EXPECT WARNING PRB315 AT 11)

(CASE where it is the same all around nothing is told)
(SHEET [probe])
(SHEET tool = 1)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M3 S500
M5
G31 Z100. F1000.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT NO WARNING PRB315)
