(Which axis #5001, #5221 and the like are of: numbers are those of controlled axes, not of letters.)
(SOURCE MB-138, MB-145; parameter 1020)

(CASE on a horizontal machining centre the fourth axis is B)
(SETTING axes = "XYZB")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
%
O1
G90 G54 G0 X1. B10.
#100=#5004
#101=#5024
#102=#5044
#5224=3.
G0 B10.
#103=#5024
G10 L2 P1 B5.
#104=#5224
#105=#2801
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 10)
(EXPECT #102 = 10)
(EXPECT #103 = 13)
(EXPECT #104 = 5)
(EXPECT #105 = 5)

(CASE there is no fifth)
(SETTING axes = "XYZB")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
%
O1
#100=#5005
M30
%
(EXPECT ALARM 115 AT 6)

(CASE nor a work offset of a fifth)
(SETTING axes = "XYZB")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
%
O1
#5225=1.
M30
%
(EXPECT ALARM 115 AT 6)

(CASE of a table about B and C these are four and five)
(SETTING axes = "XYZBC")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
(SHEET [machine.axes.C])
(SHEET rapid = 3600.0)
%
O1
G0 B10. C20.
#100=#5004
#101=#5005
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 20)

(CASE without a word of the sheet they are A, B and C)
(SHEET [machine.axes.A])
(SHEET rapid = 3600.0)
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
(SHEET [machine.axes.C])
(SHEET rapid = 3600.0)
%
O1
G0 A5. B10. C20.
#100=#5004
#101=#5005
#102=#5006
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 10)
(EXPECT #102 = 20)

(CASE P of G10 L50 and the axis of PRM count the controlled axes, too)
(SOURCE MB-260, MB-072, parameter 1020)
(CONTROL fanuc-30i)
(SETTING axes = "XYZB")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
%
O1
G10 L50
N1240 P4 R30.
G11
#100=PRM[1240]/[4]
G91 G28 B0
#101=#5024
M30
%
(EXPECT #100 = 30)
(EXPECT #101 = 30)

(CASE there is no fifth to set)
(CONTROL fanuc-30i)
(SETTING axes = "XYZB")
(SHEET [machine.axes.B])
(SHEET rapid = 3600.0)
%
O1
G10 L50
N1240 P5 R30.
G11
M30
%
(EXPECT ALARM 1144 AT 8)
