(The tool length offset behind G28, G30 and G53.)
(SOURCE FANUC 0i-MB operator's manual B-63844EN/02, 14.1.2; M700V programming manual, 12.2 paragraph 4 and 14.4; Haas 96-8000, G28)
(CONTROL fanuc-16i fanuc-30i fanuc-0i brother)
(SHEET [tools.1])
(SHEET length = 100.0)

(CASE MB-287 G28 takes the length offset off: G49 behind it leaves nothing to move)
(CONTROL fanuc-16i fanuc-30i fanuc-0i brother meldas mazatrol-iso haas)
%
O1
G90 G43 H1 G0 Z200.
G91 G28 Z0
#100=#5083
#101=#5043
G49
G90 G0 X50.
M30
%
(EXPECT MOVE 1 Z300)
(EXPECT MOVE 2 Z300)
(EXPECT MOVE 3 Z0)
(EXPECT MOVE 4 X50 Z0)
(EXPECT #100 = 0)
(EXPECT #101 = 0)

(CASE MB-287 G43 stays in force and shows, the offset comes back with H)
(CONTROL fanuc-16i fanuc-30i fanuc-0i brother meldas)
%
O1
G90 G43 H1 G0 Z200.
G91 G28 Z0
G90
#100=#4008
G0 Z10.
H1 Z10.
M30
%
(EXPECT #100 = 43)
(EXPECT MOVE 4 Z10)
(EXPECT MOVE 5 Z110)

(CASE MB-287 an axis that does not go home keeps its offset)
(CONTROL fanuc-16i fanuc-30i fanuc-0i brother meldas haas)
%
O1
G90 G43 H1 G0 Z200.
G28 X0
#100=#5083
Z50.
M30
%
(EXPECT #100 = 100)
(EXPECT MOVE 4 Z150)

(CASE MB-289 G30 does the same)
(PARAMETER 1241 = 20)
%
O1
G90 G43 H1 G0 Z200.
G91 G30 Z0
G49
G90 G0 X50.
M30
%
(EXPECT MOVE 3 Z20)
(EXPECT MOVE 4 X50 Z20)

(CASE MB-291 and so does G53 on a FANUC)
%
O1
G90 G43 H1 G0 Z200.
G53 Z0
#100=#5083
G49
G0 X50.
M30
%
(EXPECT MOVE 2 Z0)
(EXPECT #100 = 0)
(EXPECT MOVE 3 X50 Z0)

(CASE MB-291 G53 of another axis leaves the length alone)
%
O1
G90 G43 H1 G0 Z200.
G53 X10.
#100=#5083
M30
%
(EXPECT MOVE 2 X10 Z300)
(EXPECT #100 = 100)

(CASE with parameter 5001.6 the offset is back in the next block)
(PARAMETER 5001.6 = 1)
%
O1
G90 G43 H1 G0 Z200.
G91 G28 Z0
G90 G0 Z10.
M30
%
(EXPECT MOVE 4 Z110)

(CASE with parameter 5006.6 no axis moves for a change of the offset)
(PARAMETER 5006.6 = 1)
%
O1
G90 G43 H1 G0 Z200.
G49
#100=#5003
X50.
M30
%
(EXPECT #100 = 300)
(EXPECT MOVE 2 X50 Z300)

(CASE MB-296 G43 alone moves the axis up by the length, G49 alone down again)
(SOURCE 30i connection manual B-63943EN-1/02, 12.5.2: only with shifted coordinates, 5006.6, no axis moves; so has a manual of XGT-CNC, 9.5.16 caution 3)
(CONTROL fanuc-16i fanuc-30i fanuc-0i brother meldas mazatrol-iso)
(START Z = 300)
%
O1
G90 G0
G43 H1
#100=#5003
G49
G0 X10.
M30
%
(EXPECT MOVE 1 Z400)
(EXPECT MOVE 2 Z300)
(EXPECT MOVE 3 X10 Z300)
(EXPECT #100 = 300)

(CASE tool length compensation B: the axis perpendicular to the plane)
(PARAMETER 5001.1 = 1)
%
O1
G90 G18 G43 H1 G0 Y10.
#100=#5082
G17 G43 H1 Z20.
#101=#5083
#102=#5082
H0
#103=#5082
G49
#104=#5082
M30
%
(EXPECT MOVE 1 Y110)
(EXPECT #100 = 100)
(EXPECT MOVE 2 Z120)
(EXPECT #101 = 100)
(EXPECT #102 = 100)
(EXPECT #103 = 100)
(EXPECT #104 = 0)

(CASE tool length compensation C: the axis that the block names)
(PARAMETER 5001.0 = 1)
%
O1
G90 G19 G44 X10. H1 G0
#100=#5081
H0 Y5.
#101=#5081
G49
M30
%
(EXPECT MOVE 1 X-90)
(EXPECT #100 = -100)
(EXPECT #101 = 0)

(CASE tool length compensation C without an axis)
(PARAMETER 5001.0 = 1)
%
O1
G90 G0 G43 H1
M30
%
(EXPECT ALARM 27 AT 4)

(CASE tool length compensation C of a further axis)
(PARAMETER 5001.0 = 1)
%
O1
G90 G0 G43 X0 H1
G43 Z0 H1
M30
%
(EXPECT ALARM 27 AT 5)

(CASE TAL lets it)
(PARAMETER 5001.0 = 1)
(PARAMETER 5001.3 = 1)
%
O1
G90 G0 G43 X0 H1
G43 Z0 H1
#100=#5081
#101=#5083
M30
%
(EXPECT #100 = 100)
(EXPECT #101 = 100)
